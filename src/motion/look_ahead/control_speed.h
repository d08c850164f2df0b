#pragma once
// This file computes the speed limits that follow from the geometry of a path, within a block and at the junction of two blocks: NCT
// 6.2–6.4, 7.1–7.3. Speeds are in mm/s along the length to which the feed refers; where only rotary axes move, they are in degrees/s.

#include "action/step.h"
#include "motion/look_ahead/ramp.h"
#include "motion/look_ahead/speed_rules.h"

namespace kadr {

/// The properties of a block's path that determine its speed limits. In this file s is the path length to which the feed refers, and u is
/// the direction of the path: dx/ds for each machine axis x.
struct PathShape {
  double length = 0;              // path length along s, mm (degrees where only rotary axes move)
  AxisMask moves = 0;             // axes that move
  Axes start{}, end{};            // direction u at the start and at the end of the path
  Axes most{};                    // the greatest |u| of each axis along the path: axis speed divided by path speed
  Axes start_bend{}, end_bend{};  // curvature vector du/ds at the start and at the end of an arc, 1/mm; zero on a line
  double radius = 0;              // the smallest radius of an arc or spline, mm; 0: the path is a line
  double in_plane = 1;            // fraction (0 to 1) of the length s of an arc that lies in the arc's plane
  bool line = false;
  AxisMask plane = 0;  // axes of the arc's plane; on a line the axes of the active plane
};

/// Returns the path shape of a step, which must be a motion. INFERRED: under tool centre point control (NCT 25.14) the direction u is
/// sampled at the quarters of the motion.
PathShape shape_of(const Step& step);

/// Returns the acceleration along the path that all axes allow: a = min A_i/|u_i|. Its build-up time is T = max T_i (NCT chapter 7). A_i
/// and T_i are the acceleration and the build-up time of axis i, and u_i is the component of the path's direction along this axis.
/// INFERRED: where u changes along the path, the smallest a applies.
Acceleration acceleration_of(const SpeedRules& rules, const PathShape& shape);

/// Returns the highest speed in a block, mm/s: the commanded speed, reduced on the inside of arcs (NCT 6.4). The greatest feed of each axis
/// (NCT 6.2) and the normal acceleration (NCT 7.2) limit the result.
double block_speed(const SpeedRules& rules, const Motion& motion, const PathShape& shape, double commanded);

/// Returns the highest speed, mm/s, at which one block may end and the next block may start. The corner (NCT 7.1) and the jumps of
/// acceleration at arcs (NCT 7.3) limit this speed. The limits within the two blocks are not included; the caller must apply these too.
double junction_speed(const SpeedRules& rules, const PathShape& before, const PathShape& after);

/// Returns the highest speed, mm/s, at which the axes may move through a corner in constant-velocity mode (Mach3 G64). INFERRED: the
/// manuals of such controls only say that the next motion starts while the previous motion slows down. With the speed v and the change of
/// direction Δu, the axes change their speeds linearly within the time t = v·max |Δu_i|/A_i. In this time the path deviates from the corner
/// by v·|Δu|·t/8; this deviation must not exceed `tolerance`, mm. The rounded corner may extend over half of the length of each motion.
double blend_speed(const SpeedRules& rules, const PathShape& before, const PathShape& after, double tolerance);

/// Returns du/ds of each axis at the junction of two lines, 1/mm; returns zero if one of the two blocks is not a line. INFERRED (NCT 7.2):
/// κ = 2·(u2 − u1)/(L1 + L2), with the directions u1, u2 and the lengths L1, L2 of the two lines.
Axes bend_between(const PathShape& before, const PathShape& after);

/// Returns the highest path speed, mm/s, at which no axis i exceeds the acceleration `most` while the direction changes by `bend` = du/ds.
/// The result is min √(most_i/|bend_i|).
double speed_in_bend(const Axes& most, const Axes& bend);

/// Returns the highest path speed, mm/s, at which the acceleration of no axis jumps too far from one junction of lines to the next junction
/// (NCT 7.3). `bend` and `next` are the curvatures du/ds at the two junctions. The result is min √(most_i/|next_i − bend_i|): most_i is the
/// greatest allowed jump for axis i, the parameter N0403 Acc Diff.
double speed_over_step(const SpeedRules& rules, const Axes& bend, const Axes& next);

/// Returns true if two blocks form an inner corner at which G62 slows down (NCT 6.3.5). INFERRED: the corner angle is 180° minus the change
/// of direction.
bool is_slow_corner(const SpeedRules& rules, const Motion& before, const PathShape& first, const Motion& after, const PathShape& second);

}  // namespace kadr
