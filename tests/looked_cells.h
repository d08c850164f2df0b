#pragma once
// Measures the output of the least-time planner in three axes. At several positions
// in each cell it compares speed, acceleration and jerk with their limits.

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/least_time/planner.h"

namespace kadr::test {

struct Looked {
  double acceleration = 0, jerk = 0, speed = 0;  // greatest shares of the axes' limits
  double feed = 0;                               // greatest speed along the path as a share of the commanded feed
  double beyond = 0;                             // greatest CellSource::beyond
  double seconds = 0;
  std::size_t unsolved = 0;

  /// Measures the cells; calls `at` with the position at each sample.
  template <class At>
  void take(const TimedCells& cells, const MotionLimits& limits, const At& at) {
    constexpr int places = 16;
    if (cells.unsolved) ++unsolved;
    seconds += cells.seconds();
    for (std::size_t k = 0; k < cells.laws.size(); ++k) {
      beyond = std::max(beyond, cells.sources[k].beyond);
      for (int i = 0; i < places; ++i) look(cells, k, cells.laws[k].at((i + 0.5) / places), limits, at);
    }
  }

 private:
  template <class At>
  void look(const TimedCells& cells, std::size_t k, const TimeLaw::State& state, const MotionLimits& limits, const At& at) {
    std::array<double, 3> position{};
    double squares = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const Derivatives x = Derivatives::at(cells.path.data() + (k * 3 + a) * TimedCells::terms, state.distance);
      const double v = state.speed;
      squares += x.x1 * x.x1 * v * v;
      speed = std::max(speed, std::fabs(x.x1 * v) / limits.speed[a]);
      acceleration = std::max(acceleration, std::fabs(x.x1 * state.acceleration + x.x2 * v * v) / limits.acceleration[a]);
      jerk = std::max(jerk, std::fabs(x.x1 * state.jerk + 3 * x.x2 * v * state.acceleration + x.x3 * v * v * v) / limits.jerk[a]);
    }
    if (cells.sources[k].feed > 0) feed = std::max(feed, std::sqrt(squares) / cells.sources[k].feed);
    cells.position(k, state.distance, position.data());
    at(position);
  }
};

}  // namespace kadr::test
