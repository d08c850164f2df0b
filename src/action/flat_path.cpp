// FlatPath: a line, a circular arc, a planar spiral or a segment of a spline in a plane. Used by action, path; tested by
// tests/action/flat_path_test.cpp.

#include "action/flat_path.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "action/plane_spline.h"

namespace kadr {
namespace {

constexpr int max_pieces = 100'000;
constexpr int samples_per_turn = 64;
constexpr int samples_of_line = 16;

/// Returns the antiderivative of sqrt(R² + a²) by the radius R, for a spiral with R' = dR/dφ and a² = R'² + rise² (rise per radian).
double primitive(double radius, double a) { return (radius * std::hypot(radius, a) + a * a * std::asinh(radius / a)) / 2; }

/// Returns the length, mm, of a spiral around an axis. Over the angle `sweep_rad`, the radius grows by `growth`, and the spiral moves by
/// `rise` along the axis.
double spiral_length(double radius, double growth, double rise, double sweep_rad) {
  // The closed formula is used if growth / radius is above this number. Below this number, the difference of the antiderivatives would lose
  // digits, while Gauss quadrature is exact to the rounding error.
  constexpr double hardly = 1e-3;
  if (sweep_rad == 0) return std::hypot(growth, rise);
  if (std::abs(growth) > hardly * std::max(radius, radius + growth)) {
    const double a = std::hypot(growth, rise) / sweep_rad;
    return sweep_rad / growth * (primitive(radius + growth, a) - primitive(radius, a));
  }
  constexpr std::array<double, 5> place = {0.5, 0.2307653449471585, 0.7692346550528415, 0.0469100770306680, 0.9530899229693320};
  constexpr std::array<double, 5> weight = {0.2844444444444444, 0.2393143352496833, 0.2393143352496833, 0.1184634425280945,
                                            0.1184634425280945};
  double sum = 0;
  for (std::size_t i = 0; i < place.size(); ++i) sum += weight[i] * std::hypot((radius + growth * place[i]) * sweep_rad, growth, rise);
  return sum;
}

/// Returns the angle φ, in radians from the start of a spiral, at which the spiral reaches farthest in the direction `quarter` (radians
/// from the start). R(φ) is the radius and R' = dR/dφ; the angle satisfies φ − quarter = atan(R' / R(φ)). The difference of the two sides
/// rises by 1 to 2 per radian, so Newton's method converges fast.
double turning_point(double quarter, double radius, double growth_per_rad) {
  constexpr int max_steps = 30;
  constexpr double near_enough = 1e-13;
  double phi = quarter;
  for (int step = 0; step < max_steps; ++step) {
    const double r = radius + growth_per_rad * phi, squares = r * r + growth_per_rad * growth_per_rad;
    const double gap = phi - quarter - std::atan2(growth_per_rad, r);
    const double next = phi - gap / (1 + growth_per_rad * growth_per_rad / squares);
    if (std::abs(next - phi) < near_enough) break;
    phi = next;
  }
  return phi;
}

}  // namespace

void take_quarters(Box2& box, const CircleArc& arc) {
  const Vec2 first = arc.first, last = arc.last;
  const auto passes = [&](bool after, bool before, bool not_opposite) {
    if (arc.turns > 0.5) return arc.turns >= 1 || after || before;
    // excludes a very short arc opposite to the axis direction, for which the first two conditions also hold
    return after && before && not_opposite;
  };
  // `first` and `last` are vectors from the centre to the ends of the arc. The direction of an axis lies within the arc if cross(first,
  // axis) >= 0 and cross(axis, last) >= 0. Both products are also 0 if first and last are opposite to the axis, so the caller passes a
  // third condition, which excludes this case.
  if (passes(first.y <= 0, last.y >= 0, first.x >= 0 || last.x >= 0)) box.most.x = std::max(box.most.x, arc.center.x + arc.radius);
  if (passes(first.x >= 0, last.x <= 0, first.y >= 0 || last.y >= 0)) box.most.y = std::max(box.most.y, arc.center.y + arc.radius);
  if (passes(first.y >= 0, last.y <= 0, first.x <= 0 || last.x <= 0)) box.least.x = std::min(box.least.x, arc.center.x - arc.radius);
  if (passes(first.x <= 0, last.x >= 0, first.y <= 0 || last.y <= 0)) box.least.y = std::min(box.least.y, arc.center.y - arc.radius);
}

FlatPath FlatPath::line(Vec2 from, Vec2 to) {
  FlatPath path;
  path.from_ = from;
  path.to_ = to;
  return path;
}

FlatPath FlatPath::arc(Vec2 from, Vec2 to, Vec2 center, double turns) {
  FlatPath path = line(from, to);
  path.arc_ = true;
  path.center_ = center;
  path.arm_ = from - center;
  path.sweep_deg_ = 360 * turns;
  path.radius_ = kadr::length(path.arm_);
  const double end = kadr::length(to - center);
  path.radius_change_ = end - path.radius_;
  if (path.radius_ == 0) path.arm_ = end > 0 ? rotated((1 / end) * (to - center), -path.sweep_deg_) : Vec2{1, 0};
  return path;
}

double FlatPath::turn_length() const { return arc_ ? std::abs(sweep_deg_) * rad_per_deg * radius_ : 0; }

FlatPath FlatPath::spline(const PlaneSpline& curve, double from, double to) {
  FlatPath path = line(curve.at(from), curve.at(to));
  path.spline_ = &curve;
  path.spline_from_ = from;
  path.spline_to_ = to;
  return path;
}

Vec2 FlatPath::at(double part) const {
  if (part <= 0) return from_;
  if (part >= 1) return to_;
  if (spline_ != nullptr) return spline_->at(on_spline(part));
  if (!arc_) return from_ + part * (to_ - from_);
  const double growth = radius_ > 0 ? 1 + radius_change_ * part / radius_ : radius_change_ * part;
  return center_ + growth * rotated(arm_, sweep_deg_ * part);
}

Vec2 FlatPath::rate(double part) const {
  if (spline_ != nullptr) return length() * spline_->direction(on_spline(part));
  if (!arc_) return to_ - from_;
  const Vec2 out = (radius_ > 0 ? 1 / radius_ : 1) * rotated(arm_, sweep_deg_ * part);
  return radius_change_ * out + radius(part) * sweep_deg_ * rad_per_deg * Vec2{-out.y, out.x};
}

double FlatPath::length(double rise) const {
  if (spline_ != nullptr) return std::hypot((spline_to_ - spline_from_) * spline_->length(), rise);
  if (!arc_) return std::hypot(to_.x - from_.x, to_.y - from_.y, rise);
  const double sweep_rad = std::abs(sweep_deg_) * rad_per_deg;
  if (radius_change_ == 0) return rise == 0 ? radius_ * sweep_rad : std::hypot(radius_ * sweep_rad, rise);
  return spiral_length(radius_, radius_change_, rise, sweep_rad);
}

Box2 FlatPath::box() const {
  if (spline_ != nullptr) return spline_->box(spline_from_, spline_to_);
  Box2 box{from_, from_};
  box.take(to_);
  if (!arc_ || sweep_deg_ == 0) return box;
  if (radius_change_ == 0 && std::abs(sweep_deg_) <= 360) {
    const Vec2 end = to_ - center_;
    const bool ccw = sweep_deg_ > 0;
    take_quarters(box, {center_, radius_, ccw ? arm_ : end, ccw ? end : arm_, std::abs(sweep_deg_) / 360});
    return box;
  }

  const double start = angle_deg(arm_), sweep_rad = std::abs(sweep_deg_) * rad_per_deg;
  const double low = std::min(start, start + sweep_deg_), high = std::max(start, start + sweep_deg_);
  const auto take_quarter = [&](double quarter) {
    const double part = (90 * quarter - start) / sweep_deg_;
    if (radius_change_ == 0) {
      const SinCos at_quarter = sincos_deg(90 * quarter);
      const Vec2 from_center = radius_ * Vec2{at_quarter.cos, at_quarter.sin};
      box.take({from_center.x == 0 ? from_.x : center_.x + from_center.x, from_center.y == 0 ? from_.y : center_.y + from_center.y});
    } else if (const double turned = turning_point(part * sweep_rad, radius_, radius_change_ / sweep_rad);
               turned > 0 && turned < sweep_rad) {
      box.take(at(turned / sweep_rad));
    }
  };
  // A spiral with growing radius has its extreme in an axis direction up to 90° after the angle of this direction; a spiral with shrinking
  // radius has it up to 90° before that angle.
  const double slack = radius_change_ == 0 ? 0 : 1;
  const double first = std::ceil(low / 90) - slack, last = std::floor(high / 90) + slack, turn = 3 + 2 * slack;
  // In a spiral of many revolutions, only the first and the last revolution can be outermost, because the radius changes steadily.
  for (double quarter = first; quarter <= std::min(last, first + turn); ++quarter) take_quarter(quarter);
  for (double quarter = std::max(first + turn + 1, last - turn); quarter <= last; ++quarter) take_quarter(quarter);
  return box;
}

/// Returns the direction, in degrees, from the origin to a point of an arc or spiral. The result is continuous as long as the point's
/// radius `radius_at` remains greater, or remains smaller, than the distance from the centre to the origin. With e the direction from the
/// centre to the point, and c the direction from the origin to the centre:
///   radius greater:   angle of e + angle between e and the point, within ±90°
///   radius smaller:   angle of c + angle between c and the point, within ±90°
double FlatPath::absolute_deg(double part, double radius_at) const {
  const Vec2 out = rotated(arm_, sweep_deg_ * part);
  const double reach = kadr::length(arm_);
  const Vec2 point = center_ + radius_at / reach * out;
  const bool inside = radius_at > kadr::length(center_);
  const Vec2 reference = inside ? out : center_;
  return (inside ? angle_deg(arm_) + sweep_deg_ * part : angle_deg(center_)) + angle_deg({dot(reference, point), cross(reference, point)});
}

double FlatPath::swept(double part) const {
  const auto turn = [](Vec2 from, Vec2 to) { return angle_deg({dot(from, to), cross(from, to)}); };
  if (spline_ != nullptr) {  // the angles of the parts of the spline are added; each part turns by less than 180°
    const int count = samples();
    double sum = 0;
    Vec2 before = from_;
    for (int i = 1; i <= count; ++i) {
      const Vec2 here = at(part * i / count);
      sum += turn(before, here);
      before = here;
    }
    return sum;
  }
  if (!arc_) return turn(from_, at(part));
  const double distance = kadr::length(center_), here = radius(part);
  if ((radius_ > distance) == (here > distance)) return absolute_deg(part, here) - absolute_deg(0, radius_);
  // At the fraction `over` of the path, the spiral's radius equals the distance from its centre to the origin. There absolute_deg() changes
  // from one of its formulas to the other.
  const double over = (distance - radius_) / radius_change_;
  const double grown = std::nextafter(distance, 2 * distance + 1);
  const double before = radius_ > distance ? grown : distance, after = here > distance ? grown : distance;
  return absolute_deg(over, before) - absolute_deg(0, radius_) + absolute_deg(part, here) - absolute_deg(over, after);
}

int FlatPath::pieces(double chord) const {
  if (spline_ != nullptr) return spline_->pieces(spline_from_, spline_to_, chord);
  if (!arc_) return 1;
  const double widest = std::max(radius_, radius_ + radius_change_);
  const double widest_deg = chord >= widest ? 90 : std::min(90.0, 2 * std::acos(1 - chord / widest) / rad_per_deg);
  const double count = std::ceil(std::abs(sweep_deg_) / std::max(widest_deg, 1e-3));
  return static_cast<int>(std::clamp(count, 1.0, double{max_pieces}));
}

double FlatPath::curvature(double part) const {
  if (spline_ != nullptr) return spline_->curvature(on_spline(part));
  return arc_ && radius(part) > 0 ? std::copysign(1 / radius(part), sweep_deg_) : 0;
}

int FlatPath::samples() const {
  if (spline_ != nullptr) return spline_->samples();
  if (!arc_) return samples_of_line;
  return static_cast<int>(std::clamp(std::ceil(std::abs(sweep_deg_) / 360) * samples_per_turn, 1.0 * samples_per_turn, 1.0 * max_pieces));
}

}  // namespace kadr
