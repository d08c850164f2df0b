#include "stretch.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace kadr::reference {
namespace {

double square(double x) { return x * x; }

struct State {
  double v, a, j;
};

State state_of(const TimeLaw& law, double t) {
  if (law.by_time) return {law.speed(t), law.a + law.j * t, law.j};
  const double v = law.speed(t);
  return {v, law.a + law.j * law.distance(t), law.j * v};
}

/// Returns the time at which the motion has covered the distance `way` of a cell.
double time_at(const TimeLaw& law, double way) {
  if (way <= 0) return 0;
  if (way >= law.length) return law.seconds;
  double low = 0, high = law.seconds;
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    (law.distance(middle) < way ? low : high) = middle;
  }
  return high;
}

}  // namespace

Place place(const Stretch& stretch, const MotionLimits& limits, std::size_t cell, double way) {
  Place at;
  const std::size_t axes = stretch.cells.axes;
  const double* c = stretch.cells.path.data() + cell * axes * TimedCells::terms;
  const double s = way;
  double squares = 0;
  at.most = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < axes; ++a, c += TimedCells::terms) {
    at.x1[a] = c[1] + s * (2 * c[2] + s * (3 * c[3] + s * (4 * c[4] + s * 5 * c[5])));
    at.x2[a] = 2 * c[2] + s * (6 * c[3] + s * (12 * c[4] + s * 20 * c[5]));
    at.x3[a] = 6 * c[3] + s * (24 * c[4] + s * 60 * c[5]);
    squares += square(at.x1[a]);
    if (at.x1[a] != 0) at.most = std::min(at.most, square(limits.speed[a] / at.x1[a]));
  }
  at.most = std::min(at.most, square(stretch.feed[cell]) / squares);
  return at;
}

double Grid::most(std::size_t knot) const {
  if (knot == 0) return start[0].most;
  return knot == intervals() ? end[knot - 1].most : std::min(start[knot].most, end[knot - 1].most);
}

Grid grid_of(const Stretch& stretch, const MotionLimits& limits, int parts, double longest) {
  Grid grid;
  double whole = 0;
  for (const TimeLaw& law : stretch.cells.laws) whole += law.length;
  for (std::size_t k = 0; k < stretch.cells.laws.size(); ++k) {
    const double length = stretch.cells.laws[k].length;
    const int count = std::max(parts, static_cast<int>(std::ceil(length / (longest * whole))));
    for (int i = 0; i < count; ++i) {
      grid.h.push_back(length / count);
      grid.cell.push_back(k);
      grid.from.push_back(length * i / count);
      grid.start.push_back(place(stretch, limits, k, length * i / count));
      grid.end.push_back(place(stretch, limits, k, length * (i + 1) / count));
    }
  }
  for (std::size_t i = 1; i < grid.intervals(); ++i) {
    double along = 0;
    for (std::size_t a = 0; a < stretch.cells.axes; ++a) along += grid.end[i - 1].x1[a] * grid.start[i].x1[a];
    if (along < 0) throw std::runtime_error("the path turns back on itself");
  }
  return grid;
}

double PathMotion::total() const { return std::accumulate(seconds.begin(), seconds.end(), 0.0); }

PathMotion motion_of(const Stretch& stretch, const Grid& grid) {
  PathMotion motion;
  for (std::size_t i = 0; i < grid.intervals(); ++i) {
    const TimeLaw& law = stretch.cells.laws[grid.cell[i]];
    const double begins = time_at(law, grid.from[i]), ends = time_at(law, grid.from[i] + grid.h[i]);
    const State state = state_of(law, begins);
    motion.v.push_back(state.v);
    motion.a.push_back(i == 0 ? 0 : state.a);
    motion.seconds.push_back(ends - begins);
  }
  motion.v.push_back(0);
  motion.a.push_back(0);
  return motion;
}

void Shares::take(const Place& at, const MotionLimits& limits, double v, double a, double j) {
  speed = std::max(speed, v / std::sqrt(at.most));
  for (std::size_t i = 0; i < limits.speed.size(); ++i) {
    acceleration = std::max(acceleration, std::fabs(at.x1[i] * a + at.x2[i] * v * v) / limits.acceleration[i]);
    jerk = std::max(jerk, std::fabs(at.x1[i] * j + 3 * at.x2[i] * v * a + at.x3[i] * v * v * v) / limits.jerk[i]);
  }
}

constexpr int looks = 16;  // points in each cell or interval at which the limits are checked

Shares shares_planned(const Stretch& stretch, const MotionLimits& limits) {
  Shares shares;
  for (std::size_t k = 0; k < stretch.cells.laws.size(); ++k)
    for (int i = 0; i <= looks; ++i) {
      const TimeLaw& law = stretch.cells.laws[k];
      const double t = law.seconds * i / looks;
      const State state = state_of(law, t);
      shares.take(place(stretch, limits, k, std::min(law.distance(t), law.length)), limits, state.v, state.a, state.j);
    }
  return shares;
}

Shares shares_of(const Stretch& stretch, const MotionLimits& limits, const Grid& grid, const PathMotion& motion) {
  Shares shares;
  for (std::size_t k = 0; k < grid.intervals(); ++k)
    for (int i = 0; i <= looks; ++i) {
      const double v = motion.v[k], a = motion.a[k], j = (motion.a[k + 1] - a) / motion.seconds[k], t = motion.seconds[k] * i / looks;
      const double s = grid.from[k] + std::min(t * (v + t * (a / 2 + t * j / 6)), grid.h[k]);
      shares.take(place(stretch, limits, grid.cell[k], s), limits, v + t * (a + t * j / 2), a + t * j, j);
    }
  return shares;
}

double seconds_as_one_window(const Stretch& stretch, const MotionLimits& limits) {
  TimedPath path;
  path.axes = stretch.cells.axes;
  path.acceleration = limits.acceleration;
  path.jerk = limits.jerk;
  constexpr std::size_t fewest = 8;  // a straight line from rest to rest has seven phases of constant jerk, so at most seven cells
  if (stretch.cells.laws.size() < fewest) return stretch.cells.seconds();
  for (std::size_t k = 0; k < stretch.cells.laws.size(); ++k) {
    const double h = stretch.cells.laws[k].length;
    double most = std::numeric_limits<double>::infinity();
    for (const double part : LeastTime::place_parts) most = std::min(most, place(stretch, limits, k, part * h).most);
    const auto shape = stretch.cells.path.begin() + static_cast<std::ptrdiff_t>(k * path.axes * TimedPath::terms);
    path.shapes.insert(path.shapes.end(), shape, shape + static_cast<std::ptrdiff_t>(path.axes * TimedPath::terms));
    path.h.push_back(h);
    path.most.push_back(most);
    path.turns.push_back(0);
  }
  PathTimer least;
  if (!least.solve(path, {})) throw std::runtime_error("no speed was found for the whole");
  double sum = 0;
  for (std::size_t k = 0; k < path.cells(); ++k) {
    const auto& [from, to] = least.speeds()[k];
    const double h = path.h[k], v = std::sqrt(from.b);
    if (k == 0) sum += TimeLaw::from_rest(h, std::sqrt(to.b), false).seconds;
    else if (k + 1 == path.cells()) sum += TimeLaw::from_rest(h, v, true).seconds;
    else sum += TimeLaw::of_squares(h, v, from.d / 2, (to.d - from.d) / h / 2).seconds;
  }
  return sum;
}

}  // namespace kadr::reference
