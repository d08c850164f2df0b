#pragma once
// The state before the start (--setup FILE.json), and the state after it; the keys are defined in tests/golden/README.md.
// Ours besides: of offsets `length_x`, `length_x_wear`, `length_y`, `length_y_wear`, `tip_position`; of tool rows `G`, `W`, `user_bits` and
// `user` (a list); and what a printed state has: `form_table`, `shifts`, of a spindle `loop`, `surface_speed`, `css_axis`, `master`.

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

/// One row of the offset table, mm; what counts is geometry plus wear.
struct ToolOffset {
  double length = 0;
  double radius = 0;
  double length_wear = 0;
  double radius_wear = 0;
  double corner = 0;  // rounding radius of the corner
  double corner_wear = 0;
  double length_x = 0, length_y = 0, length_x_wear = 0, length_y_wear = 0;  // turning offsets (nct 23.1.18, TOL=1)
  double tip_position = 0;                                                  // code of the tip's orientation
  double whole_length() const { return length + length_wear; }
  double whole_radius() const { return radius + radius_wear; }
  friend bool operator==(const ToolOffset&, const ToolOffset&) = default;
};

struct AxisLimits {
  std::optional<double> rapid;                        // mm/min
  std::optional<std::pair<double, double>> limits;    // machine mm
  std::optional<std::pair<double, double>> zone3;     // machine mm, forbidden inside (nct 22.3)
  std::optional<std::pair<double, double>> switches;  // machine mm: where the end-position switches are hit (nct 22.1)
  std::optional<double> apart;                        // mm: how far a gantry axis may be from its master (nct 20.6)
  bool no_acceleration = false;                       // `"acceleration": null`: motions take no time to speed up
  std::optional<double> acceleration;                 // mm/s²
  std::optional<double> jerk_time;                    // s, 0: linear
  double position_error = 0;                          // mm; the axis stays that far from the command
};

/// Rotary axes of a five-axis machine in words (nct 25.1).
struct KinematicsSetup {
  std::string type;                                    // head-head, table-table, head-table; empty: none is given
  std::string axes, reversed;                          // letters
  std::map<std::string, std::vector<double>> vectors;  // T1, T2, E, D: mm
  double singular = 0.01;  // degrees: a direction so near to one that it can have with an axis where that stands is taken for it
};

struct SpindleSetup {
  std::string name;
  int channel = 1;
  double rpm = 0;
  std::string dir = "stop";
  std::optional<double> angle;                    // degrees
  std::vector<std::pair<double, double>> ranges;  // rev/min, least and most of each gear
  // Only where a set-up is the state that an earlier run printed:
  std::string loop = "open";  // or closed
  double surface_speed = 0;   // m/min
  int css_axis = 0;
  int master = 0;  // 0: none
};

/// Letters of a tool's info bits, by bit: the letter for 0, the letter for 1 (nct 12.3.1); printed from the highest bit down, "SENCV".
inline constexpr std::array<std::string_view, 5> tool_info_letters = {"IV", "CT", "NL", "ED", "US"};

/// A row of the tool management table (nct 12.3.1).
struct ToolRow {
  double type = 0;         // T
  std::uint32_t info = 0;  // bits
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

using PlaceTable = std::map<std::pair<int, int>, int>;  // {magazine, pocket} → row of the tool table, 0: empty

/// Name of a parameter: "N0107.4#0" → 107, index 4, bit "0".
struct ParameterKey {
  std::string name;   // "0107": the four digits after the N; or "CLRG", which has no N
  std::string index;  // axis name or number, channel, spindle; empty: none
  std::string bit;    // number or name; empty: none
  friend bool operator==(const ParameterKey&, const ParameterKey&) = default;
  friend bool operator<(const ParameterKey& a, const ParameterKey& b) {
    return std::tie(a.name, a.index, a.bit) < std::tie(b.name, b.index, b.bit);
  }
};
/// From "N0107.4#0" or "N107.4#0" (the same parameter), "CLRG#C03"; nothing if it is of another form.
std::optional<ParameterKey> parameter_key(std::string_view text);
/// "N0107.4#0": the one form in which a parameter is printed.
std::string text_of(const ParameterKey& key);

using ParameterValue = std::variant<double, std::string>;
using Parameters = std::map<ParameterKey, ParameterValue>;

/// What the machine's logic makes of an axis (nct 20.2 to 20.4).
enum class AxisLink : std::uint8_t { follows, exchanged, reversed, parked };

/// What the machine's logic does, and when (nct: PLC).
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
  int count = 0;      // n-th time; 0: each time
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
  std::string program;  // its text
  std::vector<std::string> axes;
};

struct ProbeHole {
  double tip_radius = 0;
  double center_x = 0, center_y = 0;
  double diameter = 0, top = 0, depth = 0;
};

struct Setup {
  std::vector<std::string> axes;  // empty: the control's own
  AxisValues start;
  bool start_in_work = false;
  std::vector<std::string> modal;  // code words
  std::optional<double> feed;      // mm/min
  std::map<int, ToolOffset> offsets;
  std::map<std::string, AxisValues>
      work_offsets;  // "G54", "G59 P7", "common"; a basic rotation other than 0 is "G17", "G18", "G19", degrees
  std::map<int, AxisValues> zeros;
  std::map<int, double> correctors;
  std::map<std::string, std::optional<double>> variables;        // "#100", "#_ALM", "#_FOFS1[1]", "R2"; nullopt: vacant
  std::map<std::string, AxisLimits> machine;                     // axis or "*"
  std::map<std::string, std::pair<double, double>> axis_limits;  // no key: of the set-up and the machine file together (session)
  KinematicsSetup kinematics;                                    // given as parameters too, where these say nothing
  std::map<int, SpindleSetup> spindles;
  int tool = 0;
  std::map<int, ToolRow> tool_table;
  PlaceTable place_table;
  std::map<int, ToolForm> form_table;
  Parameters parameters;
  std::string plane;                     // "XC": axes of the plane in order
  std::map<std::string, bool> diameter;  // axes in diameter programming
  bool single_block = false;
  std::string search;                     // "N50": the run begins by a block search for that block (nct 13.1); empty: at the start
  std::map<std::string, double> signals;  // of the PLC
  std::vector<SetupEvent> events;
  std::string clock;  // "2014-05-18T15:32:41", a date there is; empty: a fixed day, so that the same input gives the same output
  std::string ini;    // name of the control's ini file, from the folder of the program memory; empty: none
  int channel = 1;
  std::map<int, ChannelSetup> channels;  // the others
  std::vector<int> skip;                 // switches that are on
  std::vector<bool> skip_answers;        // the operator is asked before a block is skipped, and says yes or no; the last one counts on
  bool optional_stop = false;
  std::vector<AlarmId> disabled;                   // warnings and notes that are not told
  std::vector<std::string> mirror;                 // axes
  std::map<int, AxisValues> reference_points;      // machine
  std::map<int, std::optional<AxisValues>> probe;  // input → work position of the signal
  std::optional<ProbeHole> probe_hole;
  std::vector<double> points;
  std::vector<std::string> watch;
  std::map<std::string, AxisValues> shifts;                                  // "G92", "G52"; only of a state that an earlier run printed
  double feed_override = 100, rapid_override = 100, spindle_override = 100;  // %

  /// Of spindle 1 (controls that know only one).
  const SpindleSetup& spindle() const;
};

/// Shifts and switches that a set-up cannot give, but the end of a run shows.
struct RunState {
  Setup tables;  // offsets, work_offsets, parameters, tool and place tables, plane, diameter, as a next set-up would give them
  std::map<std::string, AxisValues> shifts;  // "G92", "G52"
  struct SpindleState {
    std::string loop = "open";  // or closed
    double rpm = 0;
    std::string dir = "stop";
    double surface_speed = 0;  // m/min
    int css_axis = 0;
    int master = 0;  // 0: none
    std::optional<double> angle;
  };
  std::map<int, SpindleState> spindles;
  std::map<std::string, AxisValues> frame{};  // of G68.1, G68.2 in work coordinates: "origin", "x", "y", "z"; empty: none
};

/// From JSON text.
///   returns  an error sentence naming the key that is unknown, of the wrong form, or not served yet
tl::expected<Setup, std::string> parse_setup(std::string_view json);
tl::expected<Setup, std::string> load_setup(const std::string& file);

}  // namespace kadr
