#pragma once
// Runs the least-time planner along a path of straight segments in three
// axes, samples the result, and measures it from the samples alone.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "motion/least_time/planner.h"

namespace kadr::test {

using Point = std::array<double, 3>;

struct Piece {
  Point to;
  double feed, tolerance;  // feed in mm/s, tolerance in mm
};

/// Returns the same limits for all three axes, in mm/s, mm/s² and mm/s³.
inline MotionLimits three_axes(double speed, double acceleration, double jerk) {
  return {{speed, speed, speed}, {acceleration, acceleration, acceleration}, {jerk, jerk, jerk}};
}

struct PlannedRun {
  double seconds = 0;
  double speed = 0, acceleration = 0, jerk = 0;  // greatest of any axis, from differences of the samples
  std::vector<Point> points;                     // one each millisecond
  Point end{};
  std::size_t failures = 0;
};

inline PlannedRun planned_run(const MotionLimits& limits, const std::vector<Piece>& pieces, const Point& start = {}) {
  PlannedRun run;
  const double period = 1e-3;
  double due = 0;
  Planner planner(limits, [&](const TimedCells& cells) {
    for (std::size_t k = 0; k < cells.laws.size(); ++k) {
      const TimeLaw& law = cells.laws[k];
      for (; due < law.seconds && run.seconds < 1e5; due += period) cells.position(k, law.distance(due), run.points.emplace_back().data());
      due -= law.seconds;
      run.seconds += law.seconds;
      cells.position(k, law.length, run.end.data());
    }
  });
  planner.begin(start.data());
  for (const Piece& piece : pieces) planner.line_to(piece.to.data(), piece.feed, piece.tolerance, false, 0);
  planner.stop();
  run.failures = planner.failures();
  const auto& p = run.points;
  for (std::size_t i = 3; i < p.size(); ++i)
    for (std::size_t a = 0; a < 3; ++a) {
      run.speed = std::max(run.speed, std::fabs(p[i][a] - p[i - 1][a]) / period);
      run.acceleration = std::max(run.acceleration, std::fabs(p[i][a] - 2 * p[i - 1][a] + p[i - 2][a]) / (period * period));
      run.jerk = std::max(run.jerk, std::fabs(p[i][a] - 3 * p[i - 1][a] + 3 * p[i - 2][a] - p[i - 3][a]) / (period * period * period));
    }
  return run;
}

}  // namespace kadr::test
