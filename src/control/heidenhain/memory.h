#pragma once
// What a Heidenhain TNC remembers between two blocks (spec/heidenhain 4, 9 to 13).

#include <array>
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
  bool feed_per_turn = false;    // M136
  bool shortest = false;         // M126
  bool holds_tip = false;        // M128, FUNCTION TCPM
  bool calls_always = false;     // M89
  bool moved_at_rapid = false;   // the last positioning block was at FMAX
  int cycle = -1;                // number of the cycle that a call executes; -1: none is defined
  std::array<double, 10> old{};  // values of an old cycle, by the number behind the point
  std::uint8_t old_given = 0;
  int spindle_code = -1;        // Q110
  bool inch_outermost = false;  // Q113
  Vec2 direction;               // of the last motion at its end, in the plane of that motion, programmed coordinates
  PlaneAxes direction_plane;
  bool has_direction = false;

  Modes() {
    for (double& each : scale) each = 1;
  }
};

/// A call that is open: of a label, or of a program.
struct OpenCall {
  bool of_program = false;
  bool inch = false;           // unit of the caller
  std::vector<double> locals;  // QL of the caller, if a program was called
};

struct Memory : Modes {
  std::vector<double> q = std::vector<double>(q_count), ql = std::vector<double>(local_count), qr = std::vector<double>(local_count);
  std::map<std::uint16_t, std::string> texts;                         // QS
  std::vector<OpenCall> calls;                                        // in the order of the open calls of the program flow
  std::map<std::pair<std::uint16_t, std::uint64_t>, double> repeats;  // passes left, by the place of CALL LBL … REP
  std::string selected;                                               // SEL PGM
  std::string cycle_program;                                          // cycle 12
  std::vector<Axes> pattern;                                          // PATTERN DEF: X, Y, Z of each point
};

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

}  // namespace kadr::heidenhain
