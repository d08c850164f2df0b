#pragma once
// The geometric limits of the speed on a path: of a block, and of the junction between two blocks. NCT 6.2–6.4, 7.1–7.3. Speeds are mm/s
// along the length that the feed is measured along; degrees instead of mm where only rotary axes move.

#include "action/step.h"
#include "motion/look_ahead/ramp.h"
#include "motion/look_ahead/speed_rules.h"

namespace kadr {

/// The shape of a block's path, as far as the limits need it. `u` is dx/ds by axis of the machine, s the length that the feed is measured
/// along.
struct PathShape {
  double length = 0;              // in s
  AxisMask moves = 0;             // axes that move
  Axes start{}, end{};            // u at its ends
  Axes most{};                    // the greatest |u| along the path
  Axes start_bend{}, end_bend{};  // du/ds at the ends, 1/mm: of an arc
  double radius = 0;              // the smallest radius of an arc, mm; 0: not an arc
  double in_plane = 1;            // of an arc: share of s that lies in its plane
  bool line = false;
  AxisMask plane = 0;  // axes of the arc's plane, or of the active plane
};

/// Returns the shape of a step, which must be a motion. INFERRED: where the tip is led (25.14) u is sampled over quarters of the motion.
PathShape shape_of(const Step& step);

/// Returns the acceleration that each axis allows along the path: a = min A_i/|u_i|, T = max T_i (7, INFERRED where u changes: the
/// smallest).
Acceleration acceleration_of(const SpeedRules& rules, const PathShape& shape);

/// Returns the speed of a block: the commanded one, reduced on inner arcs (6.4), within the axes' feeds (6.2) and normal acceleration
/// (7.2).
double block_speed(const SpeedRules& rules, const Motion& motion, const PathShape& shape, double commanded);

/// Returns the highest speed at which one block may end and the next start: corners (7.1), steps of acceleration at arcs (7.3). The
/// blocks' own limits are not included.
double junction_speed(const SpeedRules& rules, const PathShape& before, const PathShape& after);

/// Returns the highest speed at which a corner may be passed in constant-velocity mode (Mach3 G64). INFERRED: the manuals of such
/// controls only say that the next motion starts while the last slows down. With Δu the change of direction, the axes change their speeds
/// linearly within t = v·max |Δu_i|/A_i; meanwhile the path leaves the corner by v·|Δu|·t/8, at most `tolerance`, and each motion gives
/// half of its length to its corners.
double blend_speed(const SpeedRules& rules, const PathShape& before, const PathShape& after, double tolerance);

/// Returns du/ds by axis where two lines meet, 1/mm; zero if they are not two lines. INFERRED (7.2): κ = 2·(u2 − u1)/(L1 + L2).
Axes bend_between(const PathShape& before, const PathShape& after);

/// Returns the speed at which no axis exceeds the acceleration `most` while the direction changes by `bend`: √(most_i/|bend_i|).
double speed_in_bend(const Axes& most, const Axes& bend);

/// Returns the speed at which the acceleration of no axis jumps by more than N0403 Acc Diff from one junction of lines to the next (7.3):
/// √(most_i/|next_i − bend_i|).
double speed_over_step(const SpeedRules& rules, const Axes& bend, const Axes& next);

/// Returns true if two blocks form an inner corner at which G62 slows down (6.3.5). INFERRED: the corner angle is 180° less the change of
/// direction.
bool is_slow_corner(const SpeedRules& rules, const Motion& before, const PathShape& first, const Motion& after, const PathShape& second);

}  // namespace kadr
