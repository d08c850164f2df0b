#pragma once
// Computes the motions of the turning cycles G70 to G72 for a profile (spec/linuxcnc 7.2; interp_g7x.cc of LinuxCNC's source).

#include <cstdint>
#include <vector>

#include "control/linuxcnc/turning/profile.h"

namespace kadr::linuxcnc {

struct TurningMove {
  enum class Kind : std::uint8_t { rapid, line, arc_cw, arc_ccw };
  Kind kind = Kind::rapid;
  Point to;
  Point center{};
  bool to_start = false;  // the motion is a rapid to the start of a pass of G70
};

/// The words of a turning cycle G70 to G72, in the unit of the program. X is a radius.
struct TurningWords {
  Point start;           // start point of the cycle
  double distance = 0;   // word D: distance of the cuts from the profile; in G70 the distance of the first pass
  double last = 0;       // word E: in G70 the distance of the last pass from the profile
  double passes = 1;     // word P: number of passes of G70
  double depth = 1;      // word I: depth of a cut
  double retract = 0.5;  // word R: distance of the retract after a cut
};

/// The pockets (hollows of the profile) that are cut. The digit after the decimal point of the G code selects them.
enum class Pockets : std::uint8_t { all, none, only };

/// Computes the motions of G70: passes along the profile, each closer to the profile than the one before.
Turned finish_profile(const Profile& profile, const TurningWords& words, std::vector<TurningMove>& moves);
/// Computes the motions of G71, whose cuts are parallel to Z. If `across` is set, computes those of G72, whose cuts are parallel to X.
Turned rough_profile(Profile profile, const TurningWords& words, Pockets pockets, bool across, std::vector<TurningMove>& moves);

}  // namespace kadr::linuxcnc
