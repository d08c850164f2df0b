#pragma once
// What a Heidenhain TNC remembers between two blocks (spec/heidenhain 4, 9 to 13).

#include <array>
#include <bitset>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/matrix.h"
#include "base/vec.h"
#include "control/state/control_state.h"
#include "kinematics/five_axis.h"
#include "lang/block/block.h"

namespace kadr::heidenhain {

inline constexpr std::size_t q_count = 2000, local_count = 500;
inline constexpr std::size_t first_builder_q = 600;  // parameters of cycles that Kadr knows are below it

/// Which arcs have the feed of M109, M110 at the cutting edge (spec/heidenhain 3.8).
enum class EdgeFeed : std::uint8_t { none, all, inside };

/// The modes that are values of a fixed size: a block that fails gets all of them back.
struct Modes {
  bool begun = false;     // BEGIN PGM was executed, or the file has none
  bool has_pole = false;  // CC
  Vec2 pole;              // programmed coordinates of `pole_plane`
  PlaneAxes pole_plane;
  Axes shift{};                               // cycle 7
  AxisMask mirrored = 0;                      // cycle 8
  double rotation = 0;                        // cycle 10, degrees
  Axes scale;                                 // cycles 11 and 26
  Axes scale_centre{};                        // cycle 26: CCX …
  bool tilted = false;                        // PLANE, cycle 19
  std::optional<RotaryPair> tilt_at;          // rotary positions of the tilted plane
  Mat3 tilt;                                  // columns: the axes of the tilted system
  Axes tilt_origin{};                         // the shift in force when the plane was tilted
  double delta_length = 0, delta_radius = 0;  // DL, DR of TOOL CALL
  double tool_feed = 0;                       // F of TOOL CALL
  double feed_before = 0;                     // feed in force before the block, mm/min
  double plunge = 0;                          // M103: factor of the feed towards the workpiece; 0: off
  EdgeFeed edge_feed = EdgeFeed::none;
  bool feed_per_turn = false;               // M136
  bool shortest = false;                    // M126
  bool holds_tip = false;                   // M128, FUNCTION TCPM
  bool calls_always = false;                // M89
  bool moved_at_rapid = false;              // the last positioning block was at FMAX
  int cycle = -1;                           // number of the cycle that a call executes; -1: none is defined
  std::array<double, 10> old{};             // values of an old cycle, by the number behind the point
  std::array<double, 10> old_feed{};        // the F of these lines
  std::array<std::int8_t, 10> old_sense{};  // DR+, DR- of these lines
  std::bitset<first_builder_q> defined;     // parameters that the definition in force gives
  std::array<double, 10> contour_data{};    // cycle 20: Q1 to Q9
  bool has_contour_data = false;            // cycle 20 was defined
  double pilot_radius = 0;                  // radius of the cutter for which cycle 21 has drilled, mm; 0: it has not
  int spindle_code = -1;                    // Q110
  bool inch_outermost = false;              // Q113
  Vec2 direction;                           // of the last motion at its end, in the plane of that motion, programmed coordinates
  PlaneAxes direction_plane;
  bool has_direction = false;

  Modes() {
    for (double& each : scale) each = 1;
  }
  /// Returns true if the definition of the cycle in force has this Q parameter.
  bool given(std::size_t index) const { return index < defined.size() && defined[index]; }
};

/// A call that is open: of a label, or of a program.
struct OpenCall {
  bool of_program = false;
  bool inch = false;           // unit of the caller
  std::vector<double> locals;  // QL of the caller, if a program was called
};

/// A measuring cycle that is being executed: its motions in programmed coordinates, and where the probe has touched.
struct Probing {
  struct Step {
    bool touches = false;
    Axes to{};
    AxisMask named = 0;
  };
  int cycle = 0;
  std::size_t at = 0;
  std::vector<Step> steps;
  std::vector<Axes> touched;
};

struct Memory : Modes {
  std::vector<double> q = std::vector<double>(q_count), ql = std::vector<double>(local_count), qr = std::vector<double>(local_count);
  std::map<std::uint16_t, std::string> texts;                         // QS
  std::vector<OpenCall> calls;                                        // in the order of the open calls of the program flow
  std::map<std::pair<std::uint16_t, std::uint64_t>, double> repeats;  // passes left, by the place of CALL LBL … REP
  std::optional<Probing> probing;
  int probe_parameter = -1, probe_axis = -1, probe_sense = 1;  // TCH PROBE 0.0, 1.1: result, axis, direction
  double probe_angle = 0;                                      // TCH PROBE 1.1
  std::string datum_table;                                     // SEL TABLE
  std::string selected;                                        // SEL PGM
  std::string cycle_program;                                   // cycle 12
  std::vector<std::string> contours;                           // cycle 14: the labels, a name with its opening quotation mark
  std::map<std::uint16_t, double> global_values;               // GLOBAL DEF, for PREDEF
  std::vector<Axes> pattern;                                   // PATTERN DEF: X, Y, Z of each point
};

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

}  // namespace kadr::heidenhain
