// TimedCells is a segment of a path with its timing: positions, speed and duration. Used by the other folders of motion.

#include "motion/least_time/timed_cells.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

/// The functions S(t) and C(t). The distance s = v S + a C solves the equation s̈ = a + k s with s(0) = 0 and ṡ(0) = v. The derivatives are
/// dS/dt = 1 + k C and dC/dt = S.
struct Growth {
  double s, c;
};

Growth growth(double k, double t) {
  const double x = k * t * t;
  // Below this argument a power series replaces the hyperbolic or trigonometric functions; its first omitted term is below 1e-15.
  constexpr double series_below = 0.3;
  if (std::fabs(x) < series_below) {
    const double s = t * (1 + x / 6 * (1 + x / 20 * (1 + x / 42 * (1 + x / 72 * (1 + x / 110 * (1 + x / 156))))));
    const double c = t * t / 2 * (1 + x / 12 * (1 + x / 30 * (1 + x / 56 * (1 + x / 90 * (1 + x / 132 * (1 + x / 182))))));
    return {s, c};
  }
  const double w = std::sqrt(std::fabs(k));
  return k > 0 ? Growth{std::sinh(w * t) / w, (std::cosh(w * t) - 1) / k} : Growth{std::sin(w * t) / w, (std::cos(w * t) - 1) / k};
}

}  // namespace

double TimeLaw::distance(double t) const {
  if (by_time) return t * (v + t * (a / 2 + t * j / 6));
  const Growth g = growth(j, t);
  return v * g.s + a * g.c;
}

double TimeLaw::speed(double t) const {
  if (by_time) return v + t * (a + t * j / 2);
  const Growth g = growth(j, t);
  return v * (1 + j * g.c) + a * g.s;
}

TimeLaw::State TimeLaw::after(double t) const {
  if (by_time) return {distance(t), speed(t), a + j * t, j};
  const Growth g = growth(j, t);
  const double s = v * g.s + a * g.c, now = v * (1 + j * g.c) + a * g.s;
  return {s, now, a + j * s, j * now};
}

TimeLaw::State TimeLaw::at(double part) const {
  if (by_time) {
    const double t = part * seconds;
    return {distance(t), v + t * (a + t * j / 2), a + j * t, j};
  }
  const double s = part * length, squared = std::max(0.0, v * v + s * (2 * a + j * s)), rate = std::sqrt(squared);
  return {s, rate, a + j * s, j * rate};
}

TimeLaw TimeLaw::of_jerk(double seconds, double v, double a, double j) {
  TimeLaw law{seconds, 0, true, v, a, j};
  law.length = law.distance(seconds);
  return law;
}

TimeLaw TimeLaw::of_squares(double length, double v, double a, double j) {
  TimeLaw law{0, length, false, v, a, j};
  const double end = std::sqrt(std::max(0.0, v * v + length * (2 * a + j * length)));
  // The duration of a cell is computed from its slower end, because the speed at this end may be 0. The reversed motion takes the same
  // time.
  if (end < v) {
    const TimeLaw back = of_squares(length, end, -(a + j * length), j);
    law.seconds = back.seconds;
    return law;
  }
  double t = 2 * length / (v + end);
  constexpr int max_steps = 30;  // greatest number of Newton steps; four or five steps suffice
  for (int step = 0; step < max_steps; ++step) {
    const double error = law.distance(t) - length, rate = law.speed(t);
    if (!(rate > 0)) break;
    const double by = std::clamp(error / rate, -t, t / 2);
    t -= by;
    if (std::fabs(by) <= 1e-15 * t) break;
  }
  law.seconds = t;
  return law;
}

TimeLaw TimeLaw::from_rest(double length, double v, bool reversed) {
  const double seconds = 3 * length / v, jerk = 6 * length / (seconds * seconds * seconds);
  return reversed ? TimeLaw{seconds, length, true, v, -jerk * seconds, jerk} : TimeLaw{seconds, length, true, 0, 0, jerk};
}

void TimedCells::position(std::size_t cell, double distance, double* x) const {
  const double* c = path.data() + cell * axes * terms;
  for (std::size_t a = 0; a < axes; ++a, c += terms)
    x[a] = c[0] + distance * (c[1] + distance * (c[2] + distance * (c[3] + distance * (c[4] + distance * c[5]))));
}

double TimedCells::seconds() const {
  double sum = 0;
  for (const TimeLaw& law : laws) sum += law.seconds;
  return sum;
}

}  // namespace kadr
