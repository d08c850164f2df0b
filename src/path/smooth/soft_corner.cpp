// SoftCorner is the shape by which a corner of a path is rounded, so that the third derivative of the path stays bounded. Used by
// motion/least_time/planner and path/smooth/smooth_path.

#include "path/smooth/soft_corner.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

// The change of direction |Δu| from which a corner counts as sharp, about 29°. In the comparison programs the times for values from 0.3 to
// 1 differ by 1 %.
constexpr double sharp_from = 0.5;

/// Returns the position of an axis that starts from rest at the time 0 and moves backwards at first. The third derivative of the position
/// is −1 until t = 1, and +1 after this time.
double start(double t) { return t <= 1 ? -t * t * t / 6 : -t * t * t / 6 + (t - 1) * (t - 1) * (t - 1) / 3; }
double start_speed(double t) { return t <= 1 ? -t * t / 2 : -t * t / 2 + (t - 1) * (t - 1); }
double start_acceleration(double t) { return t <= 1 ? -t : t - 2; }

constexpr double equal = SoftCorner::equal_swings;

/// Returns the curvature k of a gentle corner at the distance r from the corner (width 1), without its constant factor.
double gentle_pulse(double r) { return start_acceleration((1 - r) * equal); }

/// Returns the curvature k of a sharp corner at the distance r from the corner (width 1), without its constant factor. One axis stops, as
/// in start() reversed, while the other axis starts. The distance is the path length that both axes together have moved.
double sharp_pulse(double r) {
  const auto gone = [](double t) { return start(equal + t) - start(equal - t); };
  double before = 0, after = equal;
  for (int halving = 0; halving < 60; ++halving) {
    const double t = (before + after) / 2;
    (gone(t) < r * gone(equal) ? before : after) = t;
  }
  const double ends = start_speed(equal - before), starts = start_speed(equal + before), speed = ends + starts;
  const double slows = -start_acceleration(equal - before), quickens = start_acceleration(equal + before);
  return (quickens * speed - starts * (slows + quickens)) / (speed * speed * speed);
}

}  // namespace

SoftCorner::SoftCorner(bool sharp) {
  constexpr double h = 1.0 / pieces;
  for (int i = 0; i < pieces; ++i) k_[static_cast<std::size_t>(i)] = sharp ? sharp_pulse(i * h) : gentle_pulse(i * h);
  double half = 0;  // Half of the integral of the curvature k over the rounding. The loop below scales k to the integral 1.
  for (std::size_t i = 0; i < pieces; ++i) half += h * (k_[i] + k_[i + 1]) / 2;
  for (double& k : k_) k *= 0.5 / half;
  for (std::size_t i = pieces; i-- > 0;) {
    slope_[i] = slope_[i + 1] + h * (k_[i] + k_[i + 1]) / 2;
    g_[i] = g_[i + 1] + h * slope_[i + 1] + h * h * (k_[i] / 6 + k_[i + 1] / 3);
  }
  for (std::size_t i = 0; i < pieces; ++i) cubic_[i] = {g_[i], -h * slope_[i], h * h * k_[i] / 2, h * h * (k_[i + 1] - k_[i]) / 6};
  const auto lowest = std::min_element(g_.begin(), g_.end());
  highest_ = std::max(g_[0], -*lowest);
  double area = 0;
  for (std::size_t i = 0; i < pieces; ++i) area += h * (g_[i] + g_[i + 1]);
  second_moment_ = std::fabs(area);
  flank_ = h * static_cast<double>(lowest - g_.begin());
}

const SoftCorner& SoftCorner::of(double bend) {
  static const SoftCorner gentle(false), sharp(true);
  return bend < sharp_from ? gentle : sharp;
}

SoftCorner::Shape SoftCorner::at(double r) const {
  const double place = r * pieces;
  if (!(place < pieces)) return {0, 0, 0};
  const auto i = static_cast<std::size_t>(place);
  const double h = (place - static_cast<double>(i)) / pieces, third = (k_[i + 1] - k_[i]) * pieces;
  return {height(r), slope_[i] - h * (k_[i] + third * h / 2), k_[i] + third * h};
}

}  // namespace kadr
