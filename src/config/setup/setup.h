#pragma once
// Setup: the state before the start (--setup FILE.json). RunState: the state after a run. tests/golden/README.md defines the keys. Kadr
// has some more: for offsets `length_x`, `length_x_wear`, `length_y`, `length_y_wear`, `tip_position`; for tool rows `G`, `W`,
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

using AxisValues = std::map<std::string, double>;  // axis name → mm or degrees

/// A row of the offset table, mm. Each offset is the sum of its geometry and its wear (`…_wear`).
struct ToolOffset {
  double length = 0;
  double radius = 0;
  double length_wear = 0;
  double radius_wear = 0;
  double corner = 0;  // corner radius of the tool
  double corner_wear = 0;
  double length_x = 0, length_y = 0, length_x_wear = 0, length_y_wear = 0;  // turning offsets (nct 23.1.18, TOL=1)
  double tip_position = 0;                                                  // code of the orientation of a turning tool's tip
  double whole_length() const { return length + length_wear; }
  double whole_radius() const { return radius + radius_wear; }
  friend bool operator==(const ToolOffset&, const ToolOffset&) = default;
};

struct AxisLimits {
  std::optional<double> rapid;                      // mm/min
  std::optional<std::pair<double, double>> limits;  // mm, machine coordinates
  // mm, machine coordinates: the least and greatest position of zone 3, which the tool must not enter (nct 22.3)
  std::optional<std::pair<double, double>> zone3;
  std::optional<std::pair<double, double>> switches;  // mm, machine coordinates: positions of the end-position switches (nct 22.1)
  std::optional<double> apart;                        // mm: permitted deviation of a gantry axis from its master (nct 20.6)
  bool no_acceleration = false;                       // `"acceleration": null`: motions need no time to accelerate
  std::optional<double> acceleration;                 // mm/s²
  std::optional<double> jerk_time;                    // s, time in which the acceleration reaches its value; 0: at once (linear)
  double position_error = 0;                          // mm; the axis stops short of its commanded position by this much
};

/// The rotary axes of a five-axis machine, in words (nct 25.1).
struct KinematicsSetup {
  std::string type;                                    // machine type: head-head, table-table, head-table; empty: not given
  std::string axes, reversed;                          // letters of the axes
  std::map<std::string, std::vector<double>> vectors;  // by the manual's names T1, T2, E, D; mm
  double singular = 0.01;  // degrees by which a tool direction may be changed if one rotary axis then need not move
};

struct SpindleSetup {
  std::string name;
  int channel = 1;
  double rpm = 0;
  std::string dir = "stop";
  std::optional<double> angle;                    // degrees
  std::vector<std::pair<double, double>> ranges;  // least and greatest spindle speed of each gear, rev/min
  // The following members are used only if the set-up is the state that an earlier run printed.
  std::string loop = "open";  // position loop of the spindle: open or closed
  double surface_speed = 0;   // m/min
  int css_axis = 0;
  int master = 0;  // number of the master spindle; 0: none
};

/// Letters of a tool's info bits, from bit 0 upwards. Of each pair, the first letter means that the bit is 0, the second that it is 1 (nct
/// 12.3.1). The letters are printed from the highest bit down: "SENCV".
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

using PocketTable = std::map<std::pair<int, int>, int>;  // {magazine, pocket} → row of the tool table; 0: empty

/// The name of a parameter: "N0107.4#0" is name "0107", index "4", bit "0".
struct ParameterKey {
  std::string name;   // "0107": the four digits after N; or "CLRG", a name without N
  std::string index;  // name or number of the axis, or number of the channel or spindle; empty: no index
  std::string bit;    // number or name of the bit; empty: the parameter as a whole
  friend bool operator==(const ParameterKey&, const ParameterKey&) = default;
  friend bool operator<(const ParameterKey& a, const ParameterKey& b) {
    return std::tie(a.name, a.index, a.bit) < std::tie(b.name, b.index, b.bit);
  }
};
/// Reads "N0107.4#0" or "N107.4#0" (the same parameter), or "CLRG#C03". Returns nullopt for a text of another form.
std::optional<ParameterKey> parameter_key(std::string_view text);
/// Returns the form in which a parameter is printed: "N0107.4#0".
std::string text_of(const ParameterKey& key);

using ParameterValue = std::variant<double, std::string>;
using Parameters = std::map<ParameterKey, ParameterValue>;

/// What the machine's logic can do with an axis (nct 20.2 to 20.4).
enum class AxisLink : std::uint8_t { follows, exchanged, reversed, parked };

/// An action of the machine's logic (nct: PLC) or of the operator, and when it takes place.
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
  std::string block;  // "N30"
  std::string code;   // "M90"
  int count = 0;      // the event occurs only the n-th time; 0: each time
  Do what = Do::start;
  std::string signal;
  double value = 0;
  int switch_number = 0;
  bool on = false;
  std::string answer;  // ok, yes, no, cancel
  int spindle = 0, master = 0;
  std::vector<std::string> axes;
};

struct ChannelSetup {
  std::string program;  // text of the program
  std::vector<std::string> axes;
};

struct ProbeHole {
  double tip_radius = 0;
  double center_x = 0, center_y = 0;
  double diameter = 0, top = 0, depth = 0;
};

struct Setup {
  std::vector<std::string> axes;  // names of the axes; empty: the axes of the control
  AxisValues start;
  bool start_in_work = false;
  std::vector<std::string> modal;  // code words
  std::optional<double> feed;      // mm/min
  std::map<int, ToolOffset> offsets;
  // By code: "G54", "G59 P7", "common". A basic rotation other than 0 has the key "G17", "G18", "G19"; degrees.
  std::map<std::string, AxisValues> work_offsets;
  std::map<int, AxisValues> zeros;
  std::map<int, double> correctors;
  std::map<std::string, std::optional<double>> variables;  // "#100", "#_ALM", "#_FOFS1[1]", "R2"; nullopt: vacant variable
  std::map<std::string, AxisLimits> machine;               // limits of the axes by axis name, or "*" for all axes
  // Limits that the session combines from set-up and machine file; not a key of the file
  std::map<std::string, std::pair<double, double>> axis_limits;
  KinematicsSetup kinematics;  // the same data may be given as parameters, which take precedence
  std::map<int, SpindleSetup> spindles;
  int tool = 0;
  std::map<int, ToolRow> tool_table;
  PocketTable place_table;
  std::map<int, ToolForm> form_table;
  Parameters parameters;
  std::string plane;                     // the first and the second axis of the plane: "XC"
  std::map<std::string, bool> diameter;  // axes programmed as diameters
  bool single_block = false;
  std::string search;                     // "N50": the run starts with a block search for this block (nct 13.1); empty: at the beginning
  std::map<std::string, double> signals;  // signals of the PLC
  std::vector<SetupEvent> events;
  // Date and time at the start: "2014-05-18T15:32:41"; empty: a fixed day, so that the same input gives the same output
  std::string clock;
  std::string ini;  // name of the control's ini file, relative to the folder of the program memory; empty: no such file
  int channel = 1;
  std::map<int, ChannelSetup> channels;  // the other channels
  std::vector<int> skip;                 // numbers of the block skip switches that are on
  // The operator's answers to whether to skip a block; the last answer applies to all further blocks; empty: the operator is not asked
  std::vector<bool> skip_answers;
  bool optional_stop = false;
  std::vector<AlarmId> disabled;               // warnings and notes that are not reported
  std::vector<std::string> mirror;             // mirrored axes
  std::map<int, AxisValues> reference_points;  // machine coordinates
  // By number of the probe input: position in work coordinates at which the probe gives its signal; nullopt: it never does
  std::map<int, std::optional<AxisValues>> probe;
  std::optional<ProbeHole> probe_hole;
  std::vector<double> points;
  std::vector<std::string> watch;
  std::map<std::string, AxisValues> shifts;                                  // by code, "G92", "G52"; only if the set-up is a printed state
  double feed_override = 100, rapid_override = 100, spindle_override = 100;  // %

  /// Returns spindle 1, for controls that have a single spindle.
  const SpindleSetup& spindle() const;
};

/// The state at the end of a run: the tables, and also what a set-up cannot set.
struct RunState {
  Setup tables;  // offsets, work_offsets, parameters, tool and place tables, plane, diameter, as a set-up for the next run
  std::map<std::string, AxisValues> shifts;  // "G92", "G52"
  struct SpindleState {
    std::string loop = "open";  // position loop of the spindle: open or closed
    double rpm = 0;
    std::string dir = "stop";
    double surface_speed = 0;  // m/min
    int css_axis = 0;
    int master = 0;  // number of the master spindle; 0: none
    std::optional<double> angle;
  };
  std::map<int, SpindleState> spindles;
  std::map<std::string, AxisValues> frame{};  // frame of G68.1, G68.2 in work coordinates: "origin", "x", "y", "z"; empty: none
};

/// Reads a set-up from JSON text.
///   returns  on failure, an error sentence with the key that is unknown, of the wrong form, or not supported yet
tl::expected<Setup, std::string> parse_setup(std::string_view json);
tl::expected<Setup, std::string> load_setup(const std::string& file);

}  // namespace kadr
