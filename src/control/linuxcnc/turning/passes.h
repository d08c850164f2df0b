#pragma once
// Computes the motions of G70 to G72 over a profile (spec/linuxcnc 7.2; interp_g7x.cc).

#include <cstdint>
#include <vector>

#include "control/linuxcnc/turning/profile.h"

namespace kadr::linuxcnc {

struct TurningMove {
  enum class Kind : std::uint8_t { rapid, line, arc_cw, arc_ccw };
  Kind kind = Kind::rapid;
  Point to;
  Point center{};
  bool to_start = false;  // rapid to the start of a pass of G70
};

/// The words of the cycle, in the unit of the program; X as a radius.
struct TurningWords {
  Point start;           // start point of the cycle
  double distance = 0;   // D: distance from the profile; for G70 that of the first pass
  double last = 0;       // E: for G70 the distance of the last pass
  double passes = 1;     // P
  double depth = 1;      // I: depth of a cut
  double retract = 0.5;  // R
};

/// Which pockets are cut (the digit after the point of the code).
enum class Pockets : std::uint8_t { all, none, only };

/// G70: follows the profile in passes that come closer to it.
Turned finish_profile(const Profile& profile, const TurningWords& words, std::vector<TurningMove>& moves);
/// G71 (`across`: G72): cuts along Z (X) down to the profile.
Turned rough_profile(Profile profile, const TurningWords& words, Pockets pockets, bool across, std::vector<TurningMove>& moves);

}  // namespace kadr::linuxcnc
