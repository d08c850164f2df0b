#pragma once
// The limits that geometry sets to the speed on a path: of a block, and of the junction between two. NCT 6.2–6.4, 7.1–7.3.
// Speeds mm/s along what the feed is measured along; degrees for mm where only rotary axes move.

#include "action/step.h"
#include "motion/look_ahead/ramp.h"
#include "motion/look_ahead/speed_rules.h"

namespace kadr {

/// What the limits need to know of a block's path. `u` is dx/ds by axis of the machine, s the way the feed is measured along.
struct PathShape {
  double length = 0;              // of s
  AxisMask moves = 0;             // axes that do
  Axes start{}, end{};            // u at its ends
  Axes most{};                    // the greatest |u| on the way
  Axes start_bend{}, end_bend{};  // du/ds there, 1/mm: of an arc
  double radius = 0;              // the smallest of an arc, mm; 0: it is none
  double in_plane = 1;            // of an arc: part of s that lies in its plane
  bool line = false;
  AxisMask plane = 0;  // axes of the arc, or of the plane in force
};

/// Of a step that is a motion. INFERRED: where the tip is led (25.14) u is looked at over its quarters.
PathShape shape_of(const Step& step);

/// The path may change its speed only as each axis can: a = min A_i/|u_i|, T = max T_i (7, INFERRED where u changes: the smallest).
Acceleration acceleration_of(const SpeedRules& rules, const PathShape& shape);

/// The speed of a block: the commanded one, less on inner arcs (6.4), within the axes' feeds (6.2) and normal acceleration (7.2).
double block_speed(const SpeedRules& rules, const Motion& motion, const PathShape& shape, double commanded);

/// The highest speed at which one block may end and the next begin: corners (7.1), steps of acceleration at arcs (7.3). Not the
/// blocks' own.
double junction_speed(const SpeedRules& rules, const PathShape& before, const PathShape& after);

/// The highest speed with which a corner may be passed in constant-velocity mode (Mach3 G64). INFERRED, no manual of such a control
/// says more than that the next motion begins while the last slows down: with Δu the change of direction, the axes change their speeds
/// evenly within t = v·max |Δu_i|/A_i; meanwhile the path leaves the corner by v·|Δu|·t/8, at most `tolerance`, and each motion gives
/// half of its way to its corners.
double blend_speed(const SpeedRules& rules, const PathShape& before, const PathShape& after, double tolerance);

/// du/ds by axis where two lines meet, 1/mm; zero if they are not two lines. INFERRED (7.2): κ = 2·(u2 − u1)/(L1 + L2).
Axes bend_between(const PathShape& before, const PathShape& after);

/// The speed at which no axis has more than `most` acceleration where the direction changes by `bend`: √(most_i/|bend_i|).
double speed_in_bend(const Axes& most, const Axes& bend);

/// The speed at which the acceleration of no axis steps by more than N0403 Acc Diff from one junction of lines to the next (7.3):
/// √(most_i/|next_i − bend_i|).
double speed_over_step(const SpeedRules& rules, const Axes& bend, const Axes& next);

/// Whether two blocks make an inner corner at which G62 slows down (6.3.5). INFERRED: the corner angle is 180° less the turn.
bool is_slow_corner(const SpeedRules& rules, const Motion& before, const PathShape& first, const Motion& after, const PathShape& second);

}  // namespace kadr
