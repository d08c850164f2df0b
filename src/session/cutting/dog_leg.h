#pragma once
// The way of a rapid motion whose axes go each at its own rate until it is there (config/rapid_way.h): a polyline, bent where one arrives.
//
//   X 100, Y 40, the same rate:   ╱‾‾‾‾   and no straight line
//
// Accelerations are left out: each axis has its rate from the first moment to the last.

#include <optional>
#include <vector>

#include "action/step.h"

namespace kadr {

/// When each axis arrives, in parts of the motion: 0 to 1. One that does not move has arrived at 0.
class DogLeg {
 public:
  /// `rates`: of the axes of the machine, mm or degrees in any one unit of time.
  ///   returns  nothing: the motion is no rapid one, or its axes go together because something else leads them
  static std::optional<DogLeg> of(const Step& step, const std::optional<Axes>& rates);

  /// Parts of the motion at which an axis arrives, in ascending order; the last is 1. Empty: nothing moves.
  const std::vector<double>& corners() const { return corners_; }
  /// How far an axis has come at a part of the motion: 0 to 1 of its way.
  double gone(std::size_t axis, double part) const { return arrives_[axis] > part ? part / arrives_[axis] : 1; }

 private:
  Axes arrives_{};
  std::vector<double> corners_;
};

}  // namespace kadr
