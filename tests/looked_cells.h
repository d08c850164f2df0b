#pragma once
// What the planner of least time hands out in three axes, looked at in places of each cell: shares of the limits.

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/least_time/planner.h"

namespace kadr::test {

struct Looked {
  double acceleration = 0, jerk = 0, speed = 0;  // shares of the axes' limits
  double feed = 0;                               // of the commanded feed: the speed along the path
  double beyond = 0;                             // CellSource::beyond
  double seconds = 0;
  std::size_t unsolved = 0;

  /// `at`: called with the position in each place.
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
      const Derivatives x = Derivatives::at(cells.path.data() + (k * 3 + a) * TimedCells::terms, state.way);
      const double v = state.speed;
      squares += x.x1 * x.x1 * v * v;
      speed = std::max(speed, std::fabs(x.x1 * v) / limits.speed[a]);
      acceleration = std::max(acceleration, std::fabs(x.x1 * state.acceleration + x.x2 * v * v) / limits.acceleration[a]);
      jerk = std::max(jerk, std::fabs(x.x1 * state.jerk + 3 * x.x2 * v * state.acceleration + x.x3 * v * v * v) / limits.jerk[a]);
    }
    if (cells.sources[k].feed > 0) feed = std::max(feed, std::sqrt(squares) / cells.sources[k].feed);
    cells.position(k, state.way, position.data());
    at(position);
  }
};

}  // namespace kadr::test
