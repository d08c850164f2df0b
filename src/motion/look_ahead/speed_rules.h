#pragma once
// The limits of a machine's speed along its path besides the programmed feed: its accelerations, and the parameters of a control that has
// them (NCT 4.1, 6.2–6.4, 7). Whatever is not stated is off: infinite, or false.

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"
#include "config/machine_profile.h"
#include "config/setup.h"

namespace kadr {

inline constexpr double unlimited = std::numeric_limits<double>::infinity();
inline constexpr double seconds_per_minute = 60;  // the parameters' feeds are per minute (nct 6.2), speeds here per second

constexpr Axes axes_filled(double value) {
  Axes axes{};
  axes.fill(value);
  return axes;
}

/// The rules; values per axis in mm or degrees, and seconds.
struct SpeedRules {
  bool in_force = false;                       // something is stated, so speeds must be planned
  AxisMask stated = 0;                         // axes whose acceleration, or its absence of a limit, is stated
  Axes acceleration = axes_filled(unlimited);  // per s²
  Axes build_up{};                             // s until it is reached; 0: linear
  bool jerk_free = false;                      // N0421 #1 JRK
  Axes most_feed = axes_filled(unlimited);     // N0305 Max Feed
  bool by_axis_change = false;                 // N0306 #0 FDF: corners are limited by the change of the axes' feeds, else by their angle
  double corner_angle = 0;                     // N0307 Crit A Diff, degrees
  double corner_feed = unlimited;              // N0308 Feed Corn
  Axes axis_change = axes_filled(unlimited);   // N0309 Crit F Diff
  double least_arc_feed = 0;                   // N0310 Circ F Min
  Axes normal = axes_filled(unlimited);        // N0402 Normal Acc, per s²
  Axes line_step = axes_filled(unlimited);     // N0403 Acc Diff, per s²
  Axes arc_step = axes_filled(unlimited);      // N0404 Acc Diff Circ, per s²
  bool slows_inner_arcs = false;               // nct 6.4
  double least_arc_part = 0;                   // N1406 CircOver
  double inner_angle = 0;                      // N1409 CornAngle, degrees
  double inner_part = 1;                       // N1410 CornOver; INFERRED: 0 is off, as a corner with a stop has G9
  double inner_before = 0, inner_after = 0;    // N1407 DecDist, N1408 AccDist, mm
  bool overlaps_rapids = false;                // N0421 ROL
  double overlap_from = 1;                     // N0422 Rapid Reduct. Ratio: share of the deceleration after which the next rapid starts
  std::optional<double> blend;  // mm: how far a corner may be rounded while one motion slows down and the next speeds up; empty: no limit
  bool frames_stop = false;     // a change of work offset, tool length or work area empties the buffer (nct 13.3): the axes stop (7.0.2)

  /// Returns true if some axis needs time to change its speed.
  bool accelerates() const;
};

/// Returns the accelerations that the set-up states, by axis or for all ("*"): `acceleration`, `jerk_time`. An axis that it does not
/// mention has the profile's, built up by its jerk, if the control plans the speed (PlannerMode::control). INFERRED: otherwise such an
/// axis has no limit, if the set-up states one of another axis.
SpeedRules speed_rules(const Setup& setup, const std::vector<std::string>& axes, const MachineProfile& profile = {});

/// Adds the parameters of the set-up, for a control that has them. Without accelerations and without a parameter that limits something
/// the rules stay off.
void obey_parameters(SpeedRules& rules, const Setup& setup, const std::vector<std::string>& axes);

}  // namespace kadr
