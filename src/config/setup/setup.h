#pragma once
// Setup: the state before a run starts (--setup FILE.json). RunState: the state after a run. tests/golden/README.md defines the keys. Kadr
// has additional keys: for offsets `length_x`, `length_x_wear`, `length_y`, `length_y_wear`, `tip_position`; for tool rows `G`, `W`,
// `user_bits` and `user` (a list); and the keys of a printed state: `form_table`, `shifts`, and for a spindle `loop`, `surface_speed`,
// `css_axis`, `master`.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "base/alarm.h"

namespace kadr {

using AxisValues = std::map<std::string, double>;  // name of an axis → its value, mm or degrees

/// A row of the offset table, mm. Each offset is the sum of its geometry and its wear (`…_wear`).
struct ToolOffset {
  double length = 0;
  double radius = 0;
  double length_wear = 0;
  double radius_wear = 0;
  double corner = 0;  // corner radius of the tool, mm
  double corner_wear = 0;
  double length_x = 0, length_y = 0, length_x_wear = 0, length_y_wear = 0;  // turning offsets, mm (nct 23.1.18, TOL=1)
  double tip_position = 0;                                                  // code for the orientation of a turning tool's tip
  double whole_length() const { return length + length_wear; }
  double whole_radius() const { return radius + radius_wear; }
  friend bool operator==(const ToolOffset&, const ToolOffset&) = default;
};

struct AxisLimits {
  std::optional<double> rapid;                      // rapid rate, mm/min
  std::optional<std::pair<double, double>> limits;  // ends of the axis' travel, mm, machine coordinates
  // The least and the greatest position, mm in machine coordinates, of zone 3, which the tool must not enter (nct 22.3).
  std::optional<std::pair<double, double>> zone3;
  std::optional<std::pair<double, double>> switches;  // positions of the end-position switches, mm, machine coordinates (nct 22.1)
  std::optional<double> apart;                        // permitted deviation of a gantry axis from its master, mm (nct 20.6)
  bool no_acceleration = false;  // true if the set-up states `"acceleration": null` for the axis: motions need no time for acceleration
  std::optional<double> acceleration;  // acceleration, mm/s²
  std::optional<double> jerk_time;     // time in which the acceleration rises from 0 to its full value, s; 0: at once (linear)
  double position_error = 0;           // distance by which the axis stops short of its commanded position, mm
};

/// The rotary axes of a five-axis machine, as words and letters of the set-up (nct 25.1).
struct KinematicsSetup {
  std::string type;            // machine type: head-head, table-table, head-table; empty: the set-up does not state it
  std::string axes, reversed;  // letters of the rotary axes; letters of those that are reversed
  std::map<std::string, std::vector<double>> vectors;  // vectors, mm, by their names in the manual: T1, T2, E, D
  // Greatest angle, in degrees, by which the tool may deviate from a programmed direction near a singular one, so that a rotary axis need
  // not turn far
  double singular = 0.01;
};

struct SpindleSetup {
  std::string name;
  int channel = 1;
  double rpm = 0;
  std::string dir = "stop";
  std::optional<double> angle;                    // angle of the spindle, degrees
  std::vector<std::pair<double, double>> ranges;  // least and greatest spindle speed of each gear, rev/min
  // The following members are used only if the set-up is the printed state of an earlier run.
  std::string loop = "open";  // position loop of the spindle: open or closed
  double surface_speed = 0;   // surface speed, m/min
  int css_axis = 0;
  int master = 0;  // number of the master spindle; 0: the spindle has no master
};

/// Letters for the bits of a tool's info word, from bit 0 upwards. The first letter of each pair means that the bit is 0, the second letter
/// that it is 1 (nct 12.3.1). The letters are printed from the highest bit down: "SENCV".
inline constexpr std::array<std::string_view, 5> tool_info_letters = {"IV", "CT", "NL", "ED", "US"};

/// A row of the tool management table (nct 12.3.1).
struct ToolRow {
  double type = 0;         // type of the tool, column T of the tool management table
  std::uint32_t info = 0;  // info bits, see tool_info_letters
  std::uint32_t form = 0, status = 0;
  double counter = 0, life = 0, warn = 0;
  double h = 0, d = 0, g = 0, w = 0, s = 0, f = 0;
  std::uint32_t user_bits = 0;
  std::array<double, 20> user{};
  friend bool operator==(const ToolRow&, const ToolRow&) = default;
};

struct ToolForm {
  double left = 0, right = 0, up = 0, down = 0, geometry = 0;
  friend bool operator==(const ToolForm&, const ToolForm&) = default;
};

// {number of the magazine, number of the pocket} → row of the tool table; 0: the pocket is empty
using PocketTable = std::map<std::pair<int, int>, int>;

/// The name of a parameter. For "N0107.4#0", the name is "0107", the index "4", the bit "0".
struct ParameterKey {
  std::string name;   // the four digits after N: "0107"; or a name without N: "CLRG"
  std::string index;  // name or number of the axis, or number of the channel or spindle; empty: no index
  std::string bit;    // number or name of the bit; empty: the parameter as a whole
  friend bool operator==(const ParameterKey&, const ParameterKey&) = default;
  friend bool operator<(const ParameterKey& a, const ParameterKey& b) {
    return std::tie(a.name, a.index, a.bit) < std::tie(b.name, b.index, b.bit);
  }
};
/// Reads "N0107.4#0" or "N107.4#0", which are the same parameter, or "CLRG#C03". Returns nullopt for a text of another form.
std::optional<ParameterKey> parameter_key(std::string_view text);
/// Returns the text of a parameter's name in the form in which messages and files have it: "N0107.4#0".
std::string text_of(const ParameterKey& key);

using ParameterValue = std::variant<double, std::string>;
using Parameters = std::map<ParameterKey, ParameterValue>;

/// The changes that the machine's logic can make to an axis (nct 20.2 to 20.4).
enum class AxisLink : std::uint8_t { follows, exchanged, reversed, parked };

/// An action of the machine's logic (nct: PLC) or of the operator, and the time at which it occurs.
struct SetupEvent {
  enum class When : std::uint8_t { block_start, block_end, code, stop, message, program_end };
  enum class Do : std::uint8_t {
    set,
    skip,
    start,
    answer,
    power_cycle,
    synchronise,
    release,
    spindle_to_axis,
    axis_to_spindle,
    exchange,
    reverse,
    park
  };
  When when = When::program_end;
  std::string block;  // number of the block at which the event occurs: "N30"
  std::string code;   // code at which the event occurs: "M90"
  int count = 0;      // which occurrence of the block or code starts the event, counted from 1; 0: every occurrence
  Do what = Do::start;
  std::string signal;
  double value = 0;
  int switch_number = 0;
  bool on = false;
  std::string answer;  // the operator's answer: ok, yes, no, cancel
  int spindle = 0, master = 0;
  std::vector<std::string> axes;
};

struct ChannelSetup {
  std::string program;  // text of the channel's program
  std::vector<std::string> axes;
};

struct ProbeHole {
  double tip_radius = 0;
  double center_x = 0, center_y = 0;
  double diameter = 0, top = 0, depth = 0;
};

struct Setup {
  std::vector<std::string> axes;          // names of the axes; empty: the axes that the control's file names
  std::vector<std::string> axes_assumed;  // those of them that only the program names (session/assumed_axes); not a key of the file
  AxisValues start;
  bool start_in_work = false;
  std::vector<std::string> modal;  // code words, such as "G90", in force at the start of the run
  std::optional<double> feed;      // feed at the start, mm/min
  std::map<int, ToolOffset> offsets;
  // Work offsets by code: "G54", "G59 P7", "common". A basic rotation other than 0 has the axis name "G17", "G18" or "G19", and is in
  // degrees.
  std::map<std::string, AxisValues> work_offsets;
  std::map<int, AxisValues> zeros;
  std::map<int, double> correctors;
  // By name, "#100", "#_ALM", "#_FOFS1[1]", "R2": value of the variable; nullopt: it is vacant
  std::map<std::string, std::optional<double>> variables;
  std::map<std::string, AxisLimits> machine;  // limits by axis name; "*": limits of all axes
  // Limits that the session combines from set-up and machine file. The set-up has no key for them.
  std::map<std::string, std::pair<double, double>> axis_limits;
  // The M codes that the machine's file names, by number, with their names in English and Russian. The set-up has no key for them.
  std::map<std::uint32_t, std::pair<std::string, std::string>> machine_codes;
  // Rotary axes of the machine; if the set-up states the same values as parameters, the parameters take precedence
  KinematicsSetup kinematics;
  std::map<int, SpindleSetup> spindles;
  int tool = 0;
  std::map<int, ToolRow> tool_table;
  PocketTable place_table;
  std::map<int, ToolForm> form_table;
  Parameters parameters;
  std::string plane;                     // names of the first and the second axis of the plane: "XC"
  std::map<std::string, bool> diameter;  // by axis name: true if the axis is programmed as a diameter
  bool single_block = false;
  std::string search;  // "N50": the run starts with a block search for this block (nct 13.1); empty: at the beginning of the program
  std::map<std::string, double> signals;  // signals of the PLC
  std::vector<SetupEvent> events;
  // Date and time at the start: "2014-05-18T15:32:41". If empty, a fixed day is used, so that the same input gives the same output.
  std::string clock;
  std::string ini;  // name of the control's ini file, relative to the folder of the program memory; empty: there is no ini file
  int channel = 1;
  // Data of the other channels, by channel number; the program itself runs in channel number `channel`
  std::map<int, ChannelSetup> channels;
  std::vector<int> skip;  // numbers of the block skip switches that are on
  // The operator's answers to the question whether to skip a block. The last answer applies to all further blocks. If empty, the operator
  // is not asked.
  std::vector<bool> skip_answers;
  bool optional_stop = false;
  std::vector<AlarmId> disabled;               // ids of the warnings and notes that are not reported
  std::vector<std::string> mirror;             // mirrored axes
  std::map<int, AxisValues> reference_points;  // positions of the reference points, by number, in machine coordinates
  // Position in work coordinates at which the probe triggers, by number of the probe input; nullopt: it never triggers.
  std::map<int, std::optional<AxisValues>> probe;
  std::optional<ProbeHole> probe_hole;
  std::optional<double> chuck_face;  // Z of the chuck's face, work coordinates, mm
  std::optional<double> tailstock;   // Z of the tip of the tailstock's centre, work coordinates, mm
  std::vector<double> points;
  std::vector<std::string> watch;
  std::map<std::string, AxisValues> shifts;  // shifts by code, "G92", "G52"; only if the set-up is a printed state
  double feed_override = 100, rapid_override = 100, spindle_override = 100;  // %

  /// Returns spindle 1, for controls that have a single spindle.
  const SpindleSetup& spindle() const;
};

/// The state at the end of a run: the tables, and also values that a set-up cannot state.
struct RunState {
  Setup tables;  // the tables as a set-up for the next run: offsets, work_offsets, parameters, tool and place tables, plane, diameter
  std::map<std::string, AxisValues> shifts;  // shifts by code: "G92", "G52"
  struct SpindleState {
    std::string loop = "open";  // position loop of the spindle: open or closed
    double rpm = 0;
    std::string dir = "stop";
    double surface_speed = 0;  // surface speed, m/min
    int css_axis = 0;
    int master = 0;  // number of the master spindle; 0: the spindle has no master
    std::optional<double> angle;
  };
  std::map<int, SpindleState> spindles;
  std::map<std::string, AxisValues> frame{};  // frame of G68.1, G68.2 in work coordinates: "origin", "x", "y", "z"; empty: no frame
};

/// Reads a set-up from JSON text.
///   returns  on failure, an error sentence with the key that is unknown, has a wrong form, or is not supported yet
tl::expected<Setup, std::string> parse_setup(std::string_view json);
tl::expected<Setup, std::string> load_setup(const std::string& file);

}  // namespace kadr
