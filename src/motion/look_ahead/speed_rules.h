#pragma once
// What limits the speed of a machine along its path besides the programmed feed: its accelerations, and of a control that has
// parameters (NCT 4.1, 6.2–6.4, 7) theirs. What nobody stated is off: infinite, or false.

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

/// Values per axis in mm or degrees, and seconds.
struct SpeedRules {
  bool in_force = false;                       // something is stated: speeds are to be planned
  AxisMask stated = 0;                         // axes of which the acceleration is, or that it has no limit
  Axes acceleration = axes_filled(unlimited);  // per s²
  Axes build_up{};                             // s until it is reached; 0: linear
  bool jerk_free = false;                      // N0421 #1 JRK
  Axes most_feed = axes_filled(unlimited);     // N0305 Max Feed
  bool by_axis_change = false;                 // N0306 #0 FDF: corners by the change of the axes' feeds, else by their angle
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
  double inner_part = 1;                       // N1410 CornOver; INFERRED: 0 is off, as a corner that stops has G9
  double inner_before = 0, inner_after = 0;    // N1407 DecDist, N1408 AccDist, mm
  bool overlaps_rapids = false;                // N0421 ROL
  double overlap_from = 1;                     // N0422 Rapid Reduct. Ratio: part of the deceleration after which the next one starts
  std::optional<double>
      blend;                 // mm: how far a corner may be rounded while one motion slows down and the next speeds up; not stated: no limit
  bool frames_stop = false;  // another zero, tool length or work area empties the buffer (nct 13.3): the axes stand (7.0.2)

  /// Some axis needs time to change its speed.
  bool accelerates() const;
};

/// The accelerations that the set-up states, by axis or for all ("*"): `acceleration`, `jerk_time`; of axes about which it says nothing
/// those of a machine whose speed the control makes (PlannerMode::control), built up by its jerk.
/// INFERRED: otherwise they have no limit, if the set-up says something of another axis.
SpeedRules speed_rules(const Setup& setup, const std::vector<std::string>& axes, const MachineProfile& profile = {});

/// Adds what the parameters of the set-up say, for a control that has them. Without accelerations and without a parameter that
/// limits something nothing comes into force.
void obey_parameters(SpeedRules& rules, const Setup& setup, const std::vector<std::string>& axes);

}  // namespace kadr
