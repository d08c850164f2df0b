#pragma once
// The motions of G70 to G72 over a profile (spec/linuxcnc 7.2; interp_g7x.cc).

#include <cstdint>
#include <vector>

#include "control/linuxcnc/turning/profile.h"

namespace kadr::linuxcnc {

struct TurningMove {
  enum class Kind : std::uint8_t { rapid, line, arc_cw, arc_ccw };
  Kind kind = Kind::rapid;
  Point to;
  Point center{};
  bool to_start = false;  // of a pass of G70
};

/// Words of the cycle, in the unit of the program; X as a radius.
struct TurningWords {
  Point start;           // where it begins
  double distance = 0;   // D: from the profile; of G70 the first one
  double last = 0;       // E: of G70 the last one
  double passes = 1;     // P
  double depth = 1;      // I: of a cut
  double retract = 0.5;  // R
};

/// Which pockets are cut (the digit behind the point).
enum class Pockets : std::uint8_t { all, none, only };

/// G70: the profile itself, in passes that come nearer.
Turned finish_profile(const Profile& profile, const TurningWords& words, std::vector<TurningMove>& moves);
/// G71 (across: G72): cuts along Z (X) down to the profile.
Turned rough_profile(Profile profile, const TurningWords& words, Pockets pockets, bool across, std::vector<TurningMove>& moves);

}  // namespace kadr::linuxcnc
