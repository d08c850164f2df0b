#pragma once
// DogLeg: the path of a rapid motion during which each axis moves at its own rate until it arrives (config/machine/rapid_path.h). The path
// is a polyline with a corner where an axis arrives.
//
//   X 100, Y 40, both at the same rate:   ╱‾‾‾‾   instead of a straight line
//
// Accelerations are ignored: each axis has its full rate from the beginning to the end of its travel.

#include <optional>
#include <vector>

#include "action/step.h"

namespace kadr {

/// Stores the arrival time of each axis as a part of the motion's time, from 0 to 1. An axis that does not move has 0.
class DogLeg {
 public:
  /// `rates`: rapid rates of the machine's axes, mm or degrees per unit of time (the same unit for all).
  ///   returns  nullopt if the motion is not rapid, or its axes are coordinated for another reason
  static std::optional<DogLeg> of(const Step& step, const std::optional<Axes>& rates);

  /// The arrival times as parts of the motion, ascending; the last one is 1. Empty if no axis moves.
  const std::vector<double>& corners() const { return corners_; }
  /// Returns the share of its travel, 0 to 1, that an axis has completed when the part `part` (0 to 1) of the motion's time is over.
  double gone(std::size_t axis, double part) const { return arrives_[axis] > part ? part / arrives_[axis] : 1; }

 private:
  Axes arrives_{};
  std::vector<double> corners_;
};

}  // namespace kadr
