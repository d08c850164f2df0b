#pragma once
// Computes the speed limits that follow from the geometry of a path: within a block, and at the junction between two blocks. NCT 6.2–6.4,
// 7.1–7.3. Speeds are in mm/s along the length to which the feed refers; in degrees/s where only rotary axes move.

#include "action/step.h"
#include "motion/look_ahead/ramp.h"
#include "motion/look_ahead/speed_rules.h"

namespace kadr {

/// The properties of a block's path that the limits need. `u` is dx/ds for each machine axis x; s is the length to which the feed refers.
struct PathShape {
  double length = 0;              // path length, in the unit of s
  AxisMask moves = 0;             // axes that move
  Axes start{}, end{};            // u at the start and the end
  Axes most{};                    // the greatest |u| along the path, per axis
  Axes start_bend{}, end_bend{};  // of an arc: du/ds at the start and the end, 1/mm
  double radius = 0;              // the smallest radius of an arc, mm; 0: not an arc
  double in_plane = 1;            // of an arc: share of s that lies in its plane
  bool line = false;
  AxisMask plane = 0;  // axes of the arc's plane, or of the active plane
};

/// Returns the path shape of a step, which must be a motion. INFERRED: under tool centre point control (NCT 25.14) u is sampled over
/// quarters of the motion.
PathShape shape_of(const Step& step);

/// Returns the acceleration along the path that all axes allow: a = min A_i/|u_i|, with the build-up time T = max T_i (NCT chapter 7;
/// INFERRED: where u changes along the path, the smallest a). A_i, T_i: acceleration and build-up time of axis i.
Acceleration acceleration_of(const SpeedRules& rules, const PathShape& shape);

/// Returns the highest speed in a block: the commanded speed, reduced on inner arcs (NCT 6.4), and limited by the greatest feed of each
/// axis (NCT 6.2) and by the normal acceleration (NCT 7.2).
double block_speed(const SpeedRules& rules, const Motion& motion, const PathShape& shape, double commanded);

/// Returns the highest speed at which one block may end and the next start: limited by the corner (NCT 7.1) and by acceleration jumps at
/// arcs (NCT 7.3). The limits within the two blocks are not included.
double junction_speed(const SpeedRules& rules, const PathShape& before, const PathShape& after);

/// Returns the highest speed at which a corner may be passed in constant-velocity mode (Mach3 G64). INFERRED: the manuals of such controls
/// only say that the next motion starts while the last slows down. With the speed v and the change of direction Δu, the axes change their
/// speeds linearly within the time t = v·max |Δu_i|/A_i. In this time the path deviates from the corner by v·|Δu|·t/8, which must not
/// exceed `tolerance`. The rounded corner may extend over half of the length of each motion.
double blend_speed(const SpeedRules& rules, const PathShape& before, const PathShape& after, double tolerance);

/// Returns du/ds for each axis at the junction of two lines, 1/mm; zero if one of the blocks is not a line. INFERRED (NCT 7.2): κ = 2·(u2 −
/// u1)/(L1 + L2), with the directions u1, u2 and the lengths L1, L2.
Axes bend_between(const PathShape& before, const PathShape& after);

/// Returns the highest speed at which no axis i exceeds the acceleration `most` while the direction changes by `bend` = du/ds: min
/// √(most_i/|bend_i|).
double speed_in_bend(const Axes& most, const Axes& bend);

/// Returns the highest speed at which no axis' acceleration jumps by more than N0403 Acc Diff (most_i) from one junction of lines to the
/// next (NCT 7.3): min √(most_i/|next_i − bend_i|).
double speed_over_step(const SpeedRules& rules, const Axes& bend, const Axes& next);

/// Returns true if two blocks form an inner corner at which G62 slows down (NCT 6.3.5). INFERRED: the corner angle is 180° less the change
/// of direction.
bool is_slow_corner(const SpeedRules& rules, const Motion& before, const PathShape& first, const Motion& after, const PathShape& second);

}  // namespace kadr
