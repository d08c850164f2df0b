// This file computes a change of speed along the path, with linear, bell-shaped or jerk-free acceleration. Used by
// motion/look_ahead/control_speed and motion/look_ahead/speed_plan.

#include "motion/look_ahead/ramp.h"

#include <algorithm>
#include <cmath>

#include "base/vec.h"

namespace kadr {
namespace {

constexpr int max_steps = 100;  // greatest number of steps of a search; bisection reaches the accuracy of double after about 60 steps
constexpr double near_enough = 1e-14;  // relative accuracy at which a search ends: a few rounding errors of double

/// Solves x³ + 2·b·x = q for x ≥ 0; b and q must not be negative. Newton's method starts above the solution. The iterates decrease
/// monotonically because the left side is convex.
double cubic_root(double b, double q) {
  if (b == 0) return std::cbrt(q);
  double x = std::min(std::cbrt(q), q / (2 * b));
  for (int step = 0; step < max_steps; ++step) {
    const double less = (x * (x * x + 2 * b) - q) / (3 * x * x + 2 * b);
    x -= less;
    if (!(less > near_enough * x)) break;
  }
  return x;
}

}  // namespace

double ramp_seconds(double change, const Acceleration& acceleration) {
  const double a = acceleration.most, t = acceleration.build_up;
  if (change == 0) return 0;
  return change >= a * t ? change / a + t : 2 * std::sqrt(change * t / a);
}

double ramp_length(double from, double to, const Acceleration& acceleration) {
  return (from + to) / 2 * ramp_seconds(std::abs(to - from), acceleration);
}

/// Solves the quadratic equation (2v + D)/2 · (D/a + T) = L for the change of speed D. If D < a·T, the equation is (2v + D) · √(D·T/a) = L,
/// which is cubic in √D. Here v is the speed `from`, L is `length`, a is the acceleration and T is the build-up time.
double reached(double from, double length, const Acceleration& acceleration) {
  const double a = acceleration.most, t = acceleration.build_up;
  if (std::isinf(a)) return length > 0 ? a : from;
  if (t == 0) return std::sqrt(from * from + 2 * a * length);
  // The coefficient b of the quadratic equation D² + 2·b·D = 2·a·(L − v·T): D is the change of speed, L the length and v the start speed.
  const double b = from + a * t / 2;
  const double rest = 2 * a * (length - from * t);
  if (rest > 0) {
    const double change = rest / (b + std::sqrt(b * b + rest));
    if (change >= a * t) return from + change;
  }
  const double root = cubic_root(from, length * std::sqrt(a / t));
  return from + root * root;
}

double top_speed(double from, double to, double length, double most, const Acceleration& acceleration) {
  const double least = std::max(from, to);
  const auto needs = [&](double top) { return ramp_length(from, top, acceleration) + ramp_length(top, to, acceleration); };
  if (most <= least || std::isinf(acceleration.most) || needs(most) <= length) return std::max(most, least);
  if (acceleration.build_up == 0) return std::clamp(std::sqrt(acceleration.most * length + (from * from + to * to) / 2), least, most);
  if (from == to) return std::min(most, reached(from, length / 2, acceleration));
  double low = least, high = most;
  for (int step = 0; step < max_steps && high - low > near_enough * high; ++step) {
    const double middle = (low + high) / 2;
    (needs(middle) <= length ? low : high) = middle;
  }
  return low;
}

double travel_seconds(double from, double to, double length, double most, const Acceleration& acceleration) {
  const double top = top_speed(from, to, length, most, acceleration);
  const double rest = length - ramp_length(from, top, acceleration) - ramp_length(top, to, acceleration);
  if (top == std::max(from, to) && rest < 0) return 2 * length / (from + to);
  return ramp_seconds(top - from, acceleration) + ramp_seconds(top - to, acceleration) + std::max(rest, 0.0) / top;
}

Ramp::Ramp(double from, double to, const Acceleration& acceleration)
    : from_(from),
      to_(to),
      peak_(acceleration.most),
      build_up_(acceleration.build_up),
      jerk_free_(acceleration.jerk_free),
      seconds_(ramp_seconds(std::abs(to - from), acceleration)),
      length_(ramp_length(from, to, acceleration)) {
  const double change = std::abs(to - from);
  if (build_up_ == 0 || change >= peak_ * build_up_ || change == 0) return;
  build_up_ = std::sqrt(change * build_up_ / peak_);
  peak_ = build_up_ > 0 ? change / build_up_ : 0;
}

/// Computes the state at the time `t` in the first half of the ramp. The second half is the mirror image of the first half.
Ramp::Moment Ramp::rising(double t, double start_speed, double sign) const {
  const double flat = std::max(t - build_up_, 0.0), build = std::min(t, build_up_);
  // `gained` is the change of speed, and `distance` the distance, since the start of the ramp. The following lines compute them for the
  // build-up of the acceleration; the time of constant acceleration is added afterwards.
  double gained = 0, distance = 0;
  if (build_up_ > 0 && jerk_free_) {
    const double turn = build_up_ / pi;
    gained = peak_ / 2 * (build - turn * std::sin(build / turn));
    distance = peak_ / 2 * (build * build / 2 + turn * turn * (std::cos(build / turn) - 1));
  } else if (build_up_ > 0) {
    gained = peak_ / build_up_ * build * build / 2;
    distance = gained * build / 3;
  }
  return {start_speed * t + sign * (distance + gained * flat + peak_ * flat * flat / 2), gained + peak_ * flat};
}

double Ramp::distance_at(double t) const {
  const double sign = to_ < from_ ? -1 : 1;
  return 2 * t <= seconds_ ? rising(t, from_, sign).distance : length_ - rising(seconds_ - t, to_, -sign).distance;
}

double Ramp::speed_at(double t) const {
  if (!(seconds_ > 0)) return to_;
  const double sign = to_ < from_ ? -1 : 1;
  return 2 * t <= seconds_ ? from_ + sign * rising(t, from_, sign).gained : to_ - sign * rising(seconds_ - t, to_, -sign).gained;
}

double Ramp::seconds_at(double at) const {
  if (at <= 0) return 0;
  if (at >= length_) return seconds_;
  double low = 0, high = seconds_;
  double t = seconds_ * at / length_;
  for (int step = 0; step < max_steps && high - low > near_enough * seconds_; ++step) {
    const double over = distance_at(t) - at;
    if (std::abs(over) <= near_enough * length_) break;
    (over > 0 ? high : low) = t;
    const double newton = t - over / speed_at(t);
    t = newton > low && newton < high ? newton : (low + high) / 2;
  }
  return t;
}

}  // namespace kadr
