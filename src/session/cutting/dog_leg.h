#pragma once
// DogLeg: the path of a rapid motion during which each axis moves at its own rate until the axis arrives (config/machine/rapid_path.h). The
// path is a polyline with a corner where an axis arrives.
//
//   X 100, Y 40, both at the same rate:   ╱‾‾‾‾   instead of a straight line
//
// Accelerations are ignored: each axis has its full rate from the beginning to the end of its travel.

#include <optional>
#include <vector>

#include "action/step.h"

namespace kadr {

/// Stores the arrival time of each axis as a fraction (0 to 1) of the motion's time. The arrival time of an axis that does not move is 0.
class DogLeg {
 public:
  /// Creates the path of the step's motion. `rates`: rapid rates of the machine's axes, mm or degrees per unit of time (the same unit for
  /// all).
  ///   returns  nullopt if the motion is not rapid, or if its axes are coordinated for another reason
  static std::optional<DogLeg> of(const Step& step, const std::optional<Axes>& rates);

  /// Returns the arrival times as fractions of the motion's time, in ascending order; the last one is 1. Empty if no axis moves.
  const std::vector<double>& corners() const { return corners_; }
  /// Returns the fraction (0 to 1) of its travel that an axis has completed at the fraction `part` (0 to 1) of the motion's time.
  double gone(std::size_t axis, double part) const { return arrives_[axis] > part ? part / arrives_[axis] : 1; }

 private:
  Axes arrives_{};
  std::vector<double> corners_;
};

}  // namespace kadr
