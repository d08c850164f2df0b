#pragma once
// DogLeg: the path of a rapid motion on which each axis moves at its own rate until it arrives (config/rapid_way.h): a polyline with a
// corner where an axis arrives.
//
//   X 100, Y 40, the same rate:   ╱‾‾‾‾   and no straight line
//
// Accelerations are ignored: each axis has its rate from the first moment to the last.

#include <optional>
#include <vector>

#include "action/step.h"

namespace kadr {

/// When each axis arrives, as a part of the motion: 0 to 1; 0 for an axis that does not move.
class DogLeg {
 public:
  /// `rates`: of the machine's axes, mm or degrees per any common unit of time.
  ///   returns  nullopt if the motion is not rapid, or its axes move together since something else leads them
  static std::optional<DogLeg> of(const Step& step, const std::optional<Axes>& rates);

  /// Parts of the motion at which an axis arrives, ascending; the last is 1. Empty if nothing moves.
  const std::vector<double>& corners() const { return corners_; }
  /// Share of its travel that an axis has completed at a part of the motion: 0 to 1.
  double gone(std::size_t axis, double part) const { return arrives_[axis] > part ? part / arrives_[axis] : 1; }

 private:
  Axes arrives_{};
  std::vector<double> corners_;
};

}  // namespace kadr
