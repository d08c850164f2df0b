#include "path/curve.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr int most_pieces = 100'000;

/// Length of a spiral around an axis, per radian: radius r at `part`, `rise` along, `growth` outwards.
/// Gauss-Legendre, five points: exact to rounding where the radius hardly grows, which controls ensure.
double spiral_length(double radius, double growth, double rise, double sweep_rad) {
  constexpr std::array<double, 5> place = {0.5, 0.2307653449471585, 0.7692346550528415, 0.0469100770306680, 0.9530899229693320};
  constexpr std::array<double, 5> weight = {0.2844444444444444, 0.2393143352496833, 0.2393143352496833, 0.1184634425280945,
                                            0.1184634425280945};
  double sum = 0;
  for (std::size_t i = 0; i < place.size(); ++i) sum += weight[i] * std::hypot((radius + growth * place[i]) * sweep_rad, growth, rise);
  return sum;
}

}  // namespace

Curve::Curve(const AxisRoles& roles, const Axes& from, const Motion& motion)
    : roles_(roles), from_(from), motion_(motion), arc_(is_arc(motion.kind)) {
  if (!arc_) return;
  first_ = motion.first;
  second_ = motion.second;
  const auto in_plane = [&](const Axes& axes) { return Vec2{axes[first_], axes[second_]}; };
  center_ = motion.center;
  arm_ = in_plane(from) - center_;
  sweep_deg_ = 360 * motion.turns * (motion.kind == MotionKind::arc_ccw ? 1 : -1);
  radius_ = kadr::length(arm_);
  radius_change_ = kadr::length(in_plane(motion.to) - center_) - radius_;
}

double Curve::linear_squares(bool outside_plane) const {
  const auto in_plane = [&](std::size_t axis) { return axis == first_ || axis == second_; };
  double sum = 0;
  for (std::size_t i = 0; i < roles_.count; ++i) {
    if (roles_.is_rotary(i) || (outside_plane && in_plane(i))) continue;
    const double way = motion_.to[i] - from_[i];
    sum += way * way;
  }
  return sum;
}

double Curve::length() const {
  if (!arc_) return std::sqrt(linear_squares(false));
  const double rise = std::sqrt(linear_squares(true));
  const double sweep_rad = std::abs(sweep_deg_) * rad_per_deg;
  if (radius_change_ == 0) return std::hypot(radius_ * sweep_rad, rise);
  return spiral_length(radius_, radius_change_, rise, sweep_rad);
}

double Curve::rotary_length() const {
  double sum = 0;
  for (std::size_t i = 0; i < roles_.count; ++i)
    if (roles_.is_rotary(i)) sum += (motion_.to[i] - from_[i]) * (motion_.to[i] - from_[i]);
  return std::sqrt(sum);
}

void Curve::set_in_plane(Axes& point, Vec2 in_plane) const {
  point[first_] = in_plane.x;
  point[second_] = in_plane.y;
}

Axes Curve::at(double part) const {
  if (part <= 0) return from_;
  if (part >= 1) return motion_.to;
  Axes point{};
  for (std::size_t i = 0; i < roles_.count; ++i) point[i] = from_[i] + part * (motion_.to[i] - from_[i]);
  if (!arc_) return point;
  const double growth = radius_ > 0 ? 1 + radius_change_ * part / radius_ : 1;
  set_in_plane(point, center_ + growth * rotated(arm_, sweep_deg_ * part));
  return point;
}

Extents Curve::extents() const {
  Extents box{from_, from_};
  const auto take = [&](std::size_t axis, double value) {
    box.least[axis] = std::min(box.least[axis], value);
    box.most[axis] = std::max(box.most[axis], value);
  };
  for (std::size_t i = 0; i < roles_.count; ++i) take(i, motion_.to[i]);
  if (!arc_ || sweep_deg_ == 0) return box;

  const double start = angle_deg(arm_);
  const double low = std::min(start, start + sweep_deg_), high = std::max(start, start + sweep_deg_);
  const double first = std::ceil(low / 90), last = std::floor(high / 90);
  const auto take_quarter = [&](double quarter) {
    const double part = std::clamp((90 * quarter - start) / sweep_deg_, 0.0, 1.0);
    const SinCos at = sincos_deg(90 * quarter);
    const double radius = radius_ + radius_change_ * part;
    const Vec2 point = center_ + radius * Vec2{at.cos, at.sin};
    if (at.sin == 0) take(first_, point.x);
    if (at.cos == 0) take(second_, point.y);
  };
  // Of many turns the outermost are the first and the last, for the radius grows steadily.
  for (double quarter = first; quarter <= std::min(last, first + 3); ++quarter) take_quarter(quarter);
  for (double quarter = std::max(first + 4, last - 3); quarter <= last; ++quarter) take_quarter(quarter);
  return box;
}

int Curve::pieces(double chord) const {
  if (!arc_) return 1;
  const double radius = std::max(radius_, radius_ + radius_change_);
  const double widest_deg = chord >= radius ? 90 : std::min(90.0, 2 * std::acos(1 - chord / radius) / rad_per_deg);
  const double count = std::ceil(std::abs(sweep_deg_) / std::max(widest_deg, 1e-3));
  return static_cast<int>(std::clamp(count, 1.0, double{most_pieces}));
}

}  // namespace kadr
