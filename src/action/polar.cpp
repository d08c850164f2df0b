// PolarPath: a path programmed in a plane and executed by a linear and a rotary axis. Used by action/curve; tested by
// tests/action/polar_test.cpp.

#include "action/polar.h"

#include <algorithm>
#include <cmath>

#include "base/extremes.h"

namespace kadr {
namespace {

constexpr int max_polar_pieces = 100'000;

}  // namespace

/// Returns the position of the linear axis, mm. The axis cannot reach points that are closer to the rotation centre than the offset; for
/// such points the result is 0.
double PolarPath::linear_at(Vec2 point) const {
  const double distance = length(point);
  return side_ * std::sqrt(std::max(0.0, (distance - offset_) * (distance + offset_)));
}

double PolarPath::skew_deg(Vec2 point) const { return offset_ == 0 ? 0 : angle_deg({linear_at(point), offset_}); }

PolarAxes PolarPath::at(double part) const {
  const Vec2 point = path_.at(part);
  return {linear_at(point), rotary_start_ + path_.swept(part) - (skew_deg(point) - skew_deg(path_.at(0)))};
}

/// With (u, w) the point in the plane, p the offset, r² = u² + w² = linear² + p², and ' the derivative by `part`:
///   linear' = (u·u' + w·w') / linear,   rotary' = (u·w' − w·u' + p·linear') / r².
PolarAxes PolarPath::rates(double part) const {
  const Vec2 point = path_.at(part), rate = path_.rate(part);
  const double linear = linear_at(point), square = dot(point, point);
  const double linear_rate = linear == 0 ? length(rate) : dot(point, rate) / linear;
  return {linear_rate, square == 0 ? 0 : (cross(point, rate) + offset_ * linear_rate) / square / rad_per_deg};
}

double PolarPath::nearest() const {
  if (!path_.is_arc()) {
    const Vec2 from = path_.at(0), along = path_.rate(0);
    const double square = dot(along, along);
    return square == 0 ? 0 : std::clamp(-dot(from, along) / square, 0.0, 1.0);
  }
  const auto distance_at = [&](double part) { return distance(part); };
  const int samples = path_.samples();
  int best = 0;
  double least = distance(0);
  for (int i = 1; i <= samples; ++i)
    if (const double here = distance(double(i) / samples); here < least) {
      least = here;
      best = i;
    }
  const double part = place_of_least(distance_at, std::max(0, best - 1) / double(samples), std::min(samples, best + 1) / double(samples));
  return distance(part) <= least ? part : double(best) / samples;
}

void PolarPath::extremes(PolarAxes& least, PolarAxes& most) const {
  const Range linear = range_of([&](double part) { return at(part).linear; }, path_.samples());
  const Range rotary = range_of([&](double part) { return at(part).rotary; }, path_.samples());
  least = {linear.least, rotary.least};
  most = {linear.most, rotary.most};
}

/// The curvature of the linear axis' travel, at the distance d from the rotation centre, is at most 1/d. So a chord of length h deviates
/// from the travel by at most h²/8d, and never by more than h/2.
int PolarPath::pieces(double chord) const {
  const double near = std::abs(linear_at(path_.at(nearest())));
  const double step = std::max(2 * chord, std::sqrt(8 * chord * near));
  const double count = std::ceil(path_.length() / step);
  return std::max(path_.pieces(chord), static_cast<int>(std::clamp(count, 1.0, double{max_polar_pieces})));
}

}  // namespace kadr
