// This file finds the limit that determines the speed of a planned cell: the limit of which the cell uses the largest fraction. The limits
// are those of motion/least_time/least_time.h. Used by motion and out; tested by tests/motion/limited_by_test.cpp.

#include "motion/look_ahead/limited_by.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

/// Speed, acceleration and jerk of one axis. The acceleration and the jerk each have two parts: one part comes from the change of the path
/// speed (along), the other part from the curvature of the path (across).
struct AxisState {
  double speed = 0, along = 0, across = 0, jerk_along = 0, jerk_across = 0;
};

/// Calls `take` once for each axis, with the axis' index and its state at the fraction `part` of the cell.
template <class Take>
void each_axis(const TimedCells& cells, std::size_t cell, double part, const Take& take) {
  const TimeLaw::State state = cells.laws[cell].at(part);
  const double s = state.distance, v = state.speed, a = state.acceleration;
  const double* c = cells.path.data() + cell * cells.axes * TimedCells::terms;
  for (std::size_t axis = 0; axis < cells.axes; ++axis, c += TimedCells::terms) {
    const double x1 = c[1] + s * (2 * c[2] + s * (3 * c[3] + s * (4 * c[4] + s * 5 * c[5])));
    const double x2 = 2 * c[2] + s * (6 * c[3] + s * (12 * c[4] + s * 20 * c[5]));
    const double x3 = 6 * c[3] + s * (24 * c[4] + s * 60 * c[5]);
    take(axis, AxisState{x1 * v, x1 * a, x2 * v * v, x1 * state.jerk, v * (3 * x2 * a + x3 * v * v)});
  }
}

/// How much of one type of limit each axis uses: fractions of the limit, summed over the sample positions of a cell.
struct Nearness {
  Axes part{}, along{}, across{};

  void take(std::size_t axis, double by_speed, double by_curvature, double limit) {
    part[axis] += std::fabs(by_speed + by_curvature) / limit;
    along[axis] += std::fabs(by_speed);
    across[axis] += std::fabs(by_curvature);
  }
  std::uint8_t nearest() const { return static_cast<std::uint8_t>(std::max_element(part.begin(), part.end()) - part.begin()); }
};

void take(LimitUsage::Share& share, double value, double limit, std::size_t axis) {
  const double part = std::fabs(value) / limit;
  if (part > share.part) share = {part, static_cast<std::uint8_t>(axis)};
}

Limit named(Limit in_line, Bend bend, bool by_curvature) {
  if (bend == Bend::corner) return Limit::corner;
  return by_curvature ? Limit::curve : in_line;
}

}  // namespace

LimitUsage shares_at(const TimedCells& cells, std::size_t cell, double part, const MotionLimits& limits) {
  LimitUsage shares;
  double squares = 0;
  each_axis(cells, cell, part, [&](std::size_t axis, const AxisState& state) {
    squares += state.speed * state.speed;
    take(shares.of_acceleration, state.along + state.across, limits.acceleration[axis], axis);
    take(shares.of_jerk, state.jerk_along + state.jerk_across, limits.jerk[axis], axis);
  });
  shares.speed = std::sqrt(squares);
  return shares;
}

LimitedBy limited_by(const TimedCells& cells, std::size_t cell, const MotionLimits& limits) {
  // The curvature is reported as the cause of the limit if its part of the acceleration or jerk exceeds this multiple of the other part.
  // The curvature then causes more than a fifth of the sum.
  constexpr double felt = 0.25;
  // Two speeds that differ by less than this relative difference count as equal. They may differ because the feed is calculated as length /
  // time.
  constexpr double same = 1e-6;
  const CellSource& source = cells.sources[cell];
  if (source.feed <= 0) return {Limit::pause, 0};
  Nearness speed, acceleration, jerk;
  double feed_part = 0;
  for (const double part : {0.0, 0.5, 1.0}) {
    double squares = 0;
    each_axis(cells, cell, part, [&](std::size_t axis, const AxisState& state) {
      squares += state.speed * state.speed;
      speed.take(axis, state.speed, 0, limits.speed[axis]);
      acceleration.take(axis, state.along, state.across, limits.acceleration[axis]);
      jerk.take(axis, state.jerk_along, state.jerk_across, limits.jerk[axis]);
    });
    feed_part += std::sqrt(squares) / source.feed;
  }
  LimitedBy nearest;
  double most = feed_part * (1 - same);
  const auto take = [&](const Nearness& nearness, Limit in_line) {
    const std::uint8_t axis = nearness.nearest();
    if (nearness.part[axis] <= most) return;
    most = nearness.part[axis];
    const bool of_path = in_line != Limit::axis_speed;
    nearest = {of_path ? named(in_line, source.bend, nearness.across[axis] > felt * nearness.along[axis]) : in_line, axis};
  };
  take(speed, Limit::axis_speed);
  take(acceleration, Limit::acceleration);
  take(jerk, Limit::jerk);
  return nearest;
}

}  // namespace kadr
