// TimedPath, the limits and estimates of the speed along a path in cells, which are computed before the solvers run. Used by the least-time
// solvers; tested by tests/motion/least_time_test.cpp.

#include "motion/least_time/timed_path.h"

#include <algorithm>
#include <array>
#include <limits>

namespace kadr {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

double squared(double x) { return x * x; }

}  // namespace

void TimedPath::clear() {
  for (std::vector<double>* const all : {&h, &most, &shapes}) all->clear();
  turns.clear();
}

/// Appends storage for the polynomials of one more cell and returns a pointer to it.
double* TimedPath::add_shapes() {
  shapes.resize(shapes.size() + axes * terms);
  return shapes.data() + shapes.size() - axes * terms;
}

void TimedPath::append(const TimedPath& more) {
  const auto add = [](auto& v, const auto& other) { v.insert(v.end(), other.begin(), other.end()); };
  add(h, more.h);
  add(most, more.most);
  add(turns, more.turns);
  add(shapes, more.shapes);
}

void TimedPath::divide_last(std::size_t parts) {
  const std::size_t row = axes * terms;
  const std::vector<double> whole(shapes.end() - static_cast<std::ptrdiff_t>(row), shapes.end());
  const double length = h.back() / static_cast<double>(parts);
  const char turns_after = turns.back();
  h.back() = length;
  h.resize(h.size() + parts - 1, length);
  most.resize(h.size(), most.back());
  turns.back() = 0;
  turns.resize(h.size(), 0);
  turns.back() = turns_after;
  for (std::size_t i = 1; i < parts; ++i) {
    const double z = static_cast<double>(i) * length;
    double* const c = add_shapes();
    for (std::size_t a = 0; a < axes; ++a) {
      const double* const q = whole.data() + a * terms;
      double* const p = c + a * terms;
      p[0] = q[0] + z * (q[1] + z * (q[2] + z * (q[3] + z * (q[4] + z * q[5]))));
      p[1] = q[1] + z * (2 * q[2] + z * (3 * q[3] + z * (4 * q[4] + z * 5 * q[5])));
      p[2] = q[2] + z * (3 * q[3] + z * (6 * q[4] + z * 10 * q[5]));
      p[3] = q[3] + z * (4 * q[4] + z * 10 * q[5]);
      p[4] = q[4] + z * 5 * q[5];
      p[5] = q[5];
    }
  }
}

void TimedPath::forget(std::size_t count) {
  const auto cut = [](auto& v, std::size_t n) { v.erase(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(n)); };
  cut(h, count);
  cut(most, count);
  cut(turns, count);
  cut(shapes, count * axes * terms);
}

TimedPath TimedPath::first(std::size_t count) const {
  const auto taken = [](const auto& v, std::size_t n) {
    return std::decay_t<decltype(v)>(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(n));
  };
  return {axes, acceleration, jerk, taken(h, count), taken(most, count), taken(turns, count), taken(shapes, count * axes * terms)};
}

double fastest_alone(const TimedPath& path, std::size_t cell) {
  // A derivative of an axis position with a magnitude below this value counts as 0, so it limits neither acceleration nor jerk.
  constexpr double none = 1e-12;
  constexpr std::array<double, 5> places = {0, 0.25, 0.5, 0.75, 1};
  double most = path.most[cell];
  for (std::size_t a = 0; a < path.axes; ++a) {
    const double* const c = path.shape(cell, a);
    if (c[2] == 0 && c[3] == 0 && c[4] == 0 && c[5] == 0) continue;
    double x2 = none, x3 = none;
    for (const double part : places) {
      const Derivatives x = Derivatives::at(c, part * path.h[cell]);
      x2 = std::max(x2, std::fabs(x.x2));
      x3 = std::max(x3, std::fabs(x.x3));
    }
    most = std::min(most, path.acceleration[a] / x2);
    if (most * most * most * x3 * x3 > squared(path.jerk[a])) most = std::min(most, std::cbrt(squared(path.jerk[a] / x3)));
  }
  return most;
}

double slowest_alone(const TimedPath& path) {
  double least = unbounded;
  for (std::size_t k = 0; k < path.cells(); ++k) least = std::min(least, fastest_alone(path, k));
  return least;
}

double soonest_rise(const TimedPath& path) {
  double least = unbounded;
  for (std::size_t a = 0; a < path.axes; ++a) least = std::min(least, 2.12 * std::sqrt(path.jerk[a]));
  return least;
}

void find_envelope(const TimedPath& path, const PathEnds& ends, std::vector<double>& middles) {
  const std::size_t n = path.cells();
  const double soonest = soonest_rise(path);
  const auto to_three_quarters = [](double b) { return std::sqrt(b * std::sqrt(b)); };
  middles.resize(n);
  // the value of b^(3/4) at the boundary before the current cell, where b is the squared path speed
  double reached = ends.from_stop ? 0 : to_three_quarters(ends.from.b);
  for (std::size_t k = 0; k < n; ++k) {
    if (k > 0 && path.turns[k - 1] != 0) reached = 0;
    reached = std::min(to_three_quarters(fastest_alone(path, k)), reached + soonest * path.h[k]);
    middles[k] = reached;
  }
  reached = ends.to_stop ? 0 : middles[n - 1];
  for (std::size_t k = n; k-- > 0;) {
    if (path.turns[k] != 0) reached = 0;
    middles[k] = reached = std::min(middles[k], reached + soonest * path.h[k]);
  }
  constexpr int rounds = 8;
  for (int round = 0; round < rounds; ++round)  // smooths the envelope
    for (std::size_t k = 1; k + 1 < n; ++k)
      if (path.turns[k] == 0 && path.turns[k - 1] == 0) middles[k] = (middles[k - 1] + 2 * middles[k] + middles[k + 1]) / 4;
  for (double& m : middles) m *= std::cbrt(m);
}

/// Computes the greatest middle ordinate of a cell from the motion in this cell, which has the length h and is next to a stop. At the
/// distance τ h from the stop the squared path speed is b = b₁ τ^(4/3), where b₁ is b at the other end of the cell. Therefore ṡ s̈ = ±2/3 τ
/// b₁^(3/2) / h and s⃛ = 2/9 b₁^(3/2) / h². The middle ordinate is a third of b₁.
double max_next_to_stop(const TimedPath& path, std::size_t cell, bool is_first, const LimitMargins& margins) {
  constexpr std::array<double, 8> places = {0, 0.12, 0.28, 0.43, 0.57, 0.72, 0.88, 1};
  const double h = path.h[cell], ahead = is_first ? 1 : -1;
  double most = unbounded;  // the greatest squared path speed b₁ at the other end of the cell that the limits allow, mm²/s²
  for (std::size_t a = 0; a < path.axes; ++a)
    for (const double place : places) {
      const Derivatives x = Derivatives::at(path.shape(cell, a), place * h);
      const double part = is_first ? place : 1 - place;
      const double jerk = 2.0 / 9 * x.x1 / (h * h) + ahead * 2 * x.x2 * part / h + x.x3 * squared(part);
      const double acceleration = ahead * 2.0 / 3 * x.x1 / h * std::cbrt(part) + x.x2 * part * std::cbrt(part);
      if (jerk != 0) most = std::min(most, std::cbrt(squared(margins.jerk * path.jerk[a] / jerk)));
      if (acceleration != 0) most = std::min(most, margins.acceleration * path.acceleration[a] / std::fabs(acceleration));
    }
  return most / 3;
}

}  // namespace kadr
