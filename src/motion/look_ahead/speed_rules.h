#pragma once
// This file has the limits of the path speed other than the programmed feed: the accelerations of the machine, and the parameters of
// controls that have them (NCT 4.1, 6.2–6.4, 7). A limit that is not stated is off: its value is infinite or false.

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"
#include "config/machine/machine_profile.h"
#include "config/setup/setup.h"

namespace kadr {

inline constexpr double unlimited = std::numeric_limits<double>::infinity();
// Converts the feeds in the control's parameters, which are per minute (nct 6.2), to the speeds in the folder motion, which are per second.
inline constexpr double seconds_per_minute = 60;

constexpr Axes axes_filled(double value) {
  Axes axes{};
  axes.fill(value);
  return axes;
}

/// A planner that holds a few straight blocks (block_window.h), as Grbl's.
struct BlockPlanner {
  std::size_t window = 15;        // blocks in the planner: the one that is executed, and those that are planned
  double junction_deviation = 0;  // mm ($11)
  double arc_tolerance = 0.002;   // greatest distance of an arc from its chords, mm ($12)
};

/// The speed limits of a channel. Values of single axes are in mm and s; rotary axes have degrees instead of mm. Numbers such as N0305 are
/// parameters of the NCT control, with their names.
struct SpeedRules {
  bool in_force = false;                       // true: at least one limit is stated, so speeds must be planned
  AxisMask stated = 0;                         // axes whose acceleration is stated, either as a number or as unlimited
  Axes acceleration = axes_filled(unlimited);  // acceleration limit of each axis, mm/s² or degrees/s²
  Axes build_up{};                             // time until the acceleration is reached, s; 0: the speed changes linearly
  bool jerk_free = false;                      // parameter N0421 #1 JRK: the acceleration builds up along half a cosine (ramp.h)
  Axes max_feed = axes_filled(unlimited);      // greatest feed of each axis, mm/s or degrees/s (N0305 Max Feed)
  // Parameter N0306 #0 FDF. True: the change of the axis feeds limits the speed in corners. False: the corner angle limits it.
  bool by_axis_change = false;
  double corner_angle = 0;                    // change of direction above which a corner limits the speed (N0307 Crit A Diff), degrees
  double corner_feed = unlimited;             // greatest feed, mm/s, at a corner above `corner_angle` (N0308 Feed Corn)
  Axes axis_change = axes_filled(unlimited);  // greatest change of an axis' feed at a corner, mm/s (N0309 Crit F Diff)
  double least_arc_feed = 0;                  // feed below which arcs are not slowed down, mm/s (N0310 Circ F Min)
  Axes normal = axes_filled(unlimited);       // greatest normal acceleration on arcs (N0402 Normal Acc), mm/s²
  Axes line_step = axes_filled(unlimited);    // greatest jump of an axis' acceleration between lines (N0403 Acc Diff), mm/s²
  Axes arc_step = axes_filled(unlimited);     // greatest jump of an axis' acceleration at arcs (N0404 Acc Diff Circ), mm/s²
  bool slows_inner_arcs = false;              // true: the feed is reduced on the inside of arcs (nct 6.4)
  double least_arc_part = 0;                  // smallest factor that reduces the feed on the inside of arcs (N1406 CircOver)
  double inner_angle = 0;                     // corner angle below which G62 slows down at inner corners (N1409 CornAngle), degrees
  // Factor of the feed at inner corners (N1410 CornOver). INFERRED: the value 0 switches the reduction off, because a program stops at a
  // corner with G9.
  double inner_part = 1;
  // Lengths of the slow zones before and after an inner corner, mm (N1407 DecDist, N1408 AccDist).
  double inner_before = 0, inner_after = 0;
  bool overlaps_rapids = false;  // true: a rapid motion may start before the previous rapid motion has ended (N0421 ROL)
  // Parameter N0422 Rapid Reduct. Ratio: the fraction (0 to 1) of the speed that a rapid motion must have lost before the next rapid motion
  // starts.
  double overlap_from = 1;
  // Greatest deviation at a corner that is rounded because one motion slows down while the next motion speeds up, mm; empty: this rule does
  // not limit the speed at corners.
  std::optional<double> blend;
  std::optional<BlockPlanner> blocks;  // nullopt: the control looks ahead over the whole stored path
  // True: a change of work offset, tool length or work area empties the look-ahead buffer (nct 13.3), so the axes stop (NCT 7.0.2).
  bool frames_stop = false;

  /// Returns true if some axis needs time to change its speed.
  bool accelerates() const;
};

/// Returns the accelerations that the set-up states for single axes or for all axes ("*") in its fields `acceleration` and `jerk_time`. For
/// an axis that the set-up does not mention, the acceleration and jerk of the machine profile apply if the control plans the speed
/// (PlannerMode::control). INFERRED: otherwise such an axis is unlimited if the set-up states the acceleration of another axis.
SpeedRules speed_rules(const Setup& setup, const std::vector<std::string>& axes, const MachineProfile& profile = {});

/// Makes the speeds those of a planner of a few blocks if the control has a parameter for the junction deviation. Returns false if it has
/// none.
bool plan_by_blocks(SpeedRules& rules, const Setup& setup, const ControlDef& control);

/// Adds the limits from the set-up's control parameters. Call it only for a control that has these parameters. If the set-up states no
/// acceleration and no limiting parameter, the rules stay off.
void obey_parameters(SpeedRules& rules, const Setup& setup, const std::vector<std::string>& axes);

}  // namespace kadr
