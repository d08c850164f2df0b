#pragma once
// The limits of the speed along the path other than the programmed feed: the accelerations of the machine, and the parameters of controls
// that support them (NCT 4.1, 6.2–6.4, 7). A limit that is not stated is off: its value is infinite, or false.

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"
#include "config/machine/machine_profile.h"
#include "config/setup/setup.h"

namespace kadr {

inline constexpr double unlimited = std::numeric_limits<double>::infinity();
inline constexpr double seconds_per_minute = 60;  // the parameters' feeds are per minute (nct 6.2), speeds here per second

constexpr Axes axes_filled(double value) {
  Axes axes{};
  axes.fill(value);
  return axes;
}

/// The speed limits of a channel. Values per axis are in mm (rotary axes: degrees) and seconds. Numbers such as N0305 are parameters of the
/// control, with their names (NCT).
struct SpeedRules {
  bool in_force = false;                       // true: a limit is stated, so speeds must be planned
  AxisMask stated = 0;                         // axes whose acceleration is stated, either as a number or as unlimited
  Axes acceleration = axes_filled(unlimited);  // mm/s² or degrees/s²
  Axes build_up{};                             // time until the acceleration is reached, s; 0: linear ramps
  bool jerk_free = false;                      // parameter N0421 #1 JRK: the acceleration builds up along half a cosine (ramp.h)
  Axes max_feed = axes_filled(unlimited);      // greatest feed of each axis (N0305 Max Feed)
  // N0306 #0 FDF: true: the change of the axis feeds limits the speed in corners; false: the corner angle limits it
  bool by_axis_change = false;
  double corner_angle = 0;                    // change of direction above which a corner limits the speed (N0307 Crit A Diff), degrees
  double corner_feed = unlimited;             // feed at such a corner (N0308 Feed Corn)
  Axes axis_change = axes_filled(unlimited);  // greatest change of an axis' feed at a corner (N0309 Crit F Diff)
  double least_arc_feed = 0;                  // feed below which arcs are not slowed down (N0310 Circ F Min)
  Axes normal = axes_filled(unlimited);       // greatest normal acceleration on arcs (N0402 Normal Acc), mm/s²
  Axes line_step = axes_filled(unlimited);    // greatest jump of an axis' acceleration between lines (N0403 Acc Diff), mm/s²
  Axes arc_step = axes_filled(unlimited);     // greatest jump of an axis' acceleration at arcs (N0404 Acc Diff Circ), mm/s²
  bool slows_inner_arcs = false;              // true: the feed is reduced on inner arcs (nct 6.4)
  double least_arc_part = 0;                  // least share of the feed on inner arcs (N1406 CircOver)
  double inner_angle = 0;                     // corner angle below which G62 slows down at inner corners (N1409 CornAngle), degrees
  double inner_part = 1;                      // N1410 CornOver; INFERRED: 0 is off, because a stop at the corner is programmed by G9
  double inner_before = 0, inner_after = 0;   // length of the slow zone before and after an inner corner (N1407 DecDist, N1408 AccDist), mm
  bool overlaps_rapids = false;               // true: a rapid motion may start before the previous one has ended (N0421 ROL)
  // N0422 Rapid Reduct. Ratio: share of the deceleration after which the next rapid motion starts
  double overlap_from = 1;
  std::optional<double> blend;  // how far a corner may be rounded while one motion slows down and the next speeds up, mm; empty: no limit
  bool frames_stop = false;  // a change of work offset, tool length or work area empties the buffer (nct 13.3): the axes stop (NCT 7.0.2)

  /// Returns true if some axis needs time to change its speed.
  bool accelerates() const;
};

/// Returns the accelerations that the set-up states, for single axes or for all ("*"): its fields `acceleration` and `jerk_time`. For an
/// axis that the set-up does not mention, the acceleration and jerk of the machine profile apply if the control plans the speed
/// (PlannerMode::control). INFERRED: otherwise such an axis is unlimited if the set-up states the acceleration of another axis.
SpeedRules speed_rules(const Setup& setup, const std::vector<std::string>& axes, const MachineProfile& profile = {});

/// Adds the limits from the set-up's control parameters, for a control that has these parameters. If no acceleration and no limiting
/// parameter is stated, the rules stay off.
void obey_parameters(SpeedRules& rules, const Setup& setup, const std::vector<std::string>& axes);

}  // namespace kadr
