// Curve: the path of one Motion from the tool's position: a line, an arc, a spiral, a helix, a cone or a spline. Used by action, motion,
// out, path; tested by tests/action/curve_test.cpp.

#include "action/curve.h"

#include <algorithm>
#include <cmath>

namespace kadr {

namespace {

// Limit in mm for FeedAlong::xyz. If the common travel of X, Y and Z is shorter, these axes count as not moving. LinuxCNC calls this limit
// `tiny` (find_straight_length).
constexpr double stands_within = 1e-7;

AxisMask followers_of(const MotionDetail* detail) {
  AxisMask axes = 0;
  for (const Follower& follower : detail->followers) axes |= AxisMask{1} << follower.axis;
  return axes;
}

}  // namespace

void Curve::find_path() {
  if (const MotionDetail* const detail = motion_.detail.get(); detail != nullptr) {
    surface_ = detail->surface;
    rolled_ = detail->rolled;
    following_ = followers_of(detail);
  }
  if (!straight()) flat_ = plane_path();
}

FlatPath Curve::plane_path() const {
  if (spline_) return FlatPath::spline(*motion_.detail->spline.curve, motion_.detail->spline.from, motion_.detail->spline.to);
  const bool flat = surface_ == PathSurface::plane;
  const Vec2 start = flat ? Vec2{from_[first_], from_[second_]} : motion_.detail->flat_from;
  const Vec2 end = flat ? Vec2{motion_.to[first_], motion_.to[second_]} : motion_.detail->flat_to;
  if (!arc_) return FlatPath::line(start, end);
  Vec2 center = motion_.center;
  // the centre of a programmed arc is in axis units (degrees for the rotary axis), so it is converted to mm
  if (surface_ == PathSurface::cylinder)
    center = start + Vec2{(center.x - from_[first_]) / unit(first_), (center.y - from_[second_]) / unit(second_)};
  return FlatPath::arc(start, end, center, motion_.kind == MotionKind::arc_ccw ? motion_.turns : -motion_.turns);
}

/// Returns the units of an axis per mm of the unrolled surface: degrees per mm for the rotary axis of a cylinder, 1 for any other axis.
double Curve::unit(std::size_t axis) const {
  return surface_ == PathSurface::cylinder && roles_.is_rotary(axis) ? 1 / (motion_.detail->radius * rad_per_deg) : 1;
}

PolarPath Curve::polar() const { return {flat_, motion_.detail->side, motion_.detail->offset, from_[second_]}; }

double Curve::length() const {
  const double outside = rise(FeedAlong::path);
  return straight() ? outside : flat_.length(outside);
}

double Curve::rotary_length() const { return std::sqrt(squares(roles_.rotary & own_axes() & ~plane_axes())); }

AxisMask Curve::xyz_axes() const {
  AxisMask axes = 0;
  for (const int axis : roles_.xyz)
    if (axis >= 0) axes |= AxisMask{1} << axis;
  return axes;
}

/// Returns the travel, mm, of the axes that are not in the plane of the path. `along` selects which of these axes count.
double Curve::rise(FeedAlong along) const {
  if (along == FeedAlong::arc && arc_) return 0;
  if (along == FeedAlong::xyz) {
    const double moved = squares(xyz_axes() & own_axes() & ~plane_axes());
    if (!straight() || moved > stands_within * stands_within) return std::sqrt(moved);
  }
  return std::sqrt(squares((along == FeedAlong::all_axes ? own_axes() : own_axes() & ~roles_.rotary) & ~plane_axes()));
}

bool Curve::measures_path(FeedAlong along) const {
  if (along == FeedAlong::turn) return straight();
  if (along == FeedAlong::xyz) return (all_axes() & ~(xyz_axes() | roles_.rotary)) == 0;
  if (along != FeedAlong::arc || !arc_) return along != FeedAlong::all_axes || (roles_.rotary & all_axes()) == 0;
  bool flat = true;  // true if no axis moves outside the plane of the arc
  for (std::size_t i = 0; i < roles_.count; ++i) flat = flat && ((plane_axes() >> i & 1U) != 0 || travel(i) == 0);
  return flat;
}

double Curve::length(FeedAlong along) const {
  if (const double turned = along == FeedAlong::turn ? flat_.turn_length() : 0; turned > 0) return turned;
  const double path_length = straight() ? rise(along) : flat_.length(rise(along));
  // a path without linear travel has its rotary travel as its length: a degree counts as 1 mm
  return path_length > 0 ? path_length : rotary_length();
}

double Curve::rate(FeedAlong along, double part) const {
  if (straight() || flat_.length() == 0) return length(along);
  if (const double turned = along == FeedAlong::turn ? flat_.turn_length() : 0; turned > 0) return turned;
  return std::hypot(kadr::length(flat_.rate(part)), rise(along));
}

/// Converts a point of the flat path to positions of the plane's two axes.
Vec2 Curve::in_axes(Vec2 flat) const {
  if (surface_ != PathSurface::cylinder) return flat;
  const Vec2 delta = flat - flat_.at(0);
  return {from_[first_] + delta.x * unit(first_), from_[second_] + delta.y * unit(second_)};
}

void Curve::set_in_plane(Axes& point, Vec2 flat) const {
  const Vec2 there = in_axes(flat);
  point[first_] = there.x;
  point[second_] = there.y;
}

/// Sets the follower axes of `point`. A follower travels as far as its master. In a rotated frame, the programmed end of the follower may
/// require another travel; the difference is then spread evenly over the motion.
void Curve::set_followers(Axes& point, double part) const {
  for (const Follower& follower : motion_.detail->followers) {
    const double rest = travel(follower.axis) - follower.sign * travel(follower.master);
    point[follower.axis] = from_[follower.axis] + follower.sign * (point[follower.master] - from_[follower.master]) + part * rest;
  }
}

Axes Curve::at(double part) const {
  if (part <= 0) return from_;
  if (part >= 1) return motion_.to;
  Axes point{};
  for (std::size_t i = 0; i < roles_.count; ++i) point[i] = from_[i] + part * travel(i);
  if (straight()) return point;
  if (surface_ == PathSurface::polar) {
    const PolarAxes axes = polar().at(part);
    point[first_] = axes.linear;
    point[second_] = axes.rotary;
  } else {
    set_in_plane(point, flat_.at(part));
  }
  if (following_ != 0) set_followers(point, part);
  return point;
}

Axes Curve::rates(double part) const {
  Axes rates{};
  for (std::size_t i = 0; i < roles_.count; ++i) rates[i] = travel(i);
  if (straight()) return rates;
  if (surface_ == PathSurface::polar) {
    const PolarAxes axes = polar().rates(part);
    rates[first_] = axes.linear;
    rates[second_] = axes.rotary;
  } else {
    const Vec2 flat = flat_.rate(part);
    rates[first_] = flat.x * unit(first_);
    rates[second_] = flat.y * unit(second_);
  }
  for (std::size_t n = 0; following_ != 0 && n < motion_.detail->followers.size(); ++n) {
    const Follower& follower = motion_.detail->followers[n];
    rates[follower.axis] = follower.sign * rates[follower.master] + (travel(follower.axis) - follower.sign * travel(follower.master));
  }
  return rates;
}

Axes Curve::programmed(double part) const {
  Axes point = at(part);
  if (surface_ == PathSurface::polar) set_in_plane(point, flat_.at(part));
  return point;
}

double Curve::nearest() const { return surface_ == PathSurface::polar ? polar().nearest() : 0; }

Extents Curve::extents() const {
  Extents box{from_, from_};
  for (std::size_t i = 0; i < roles_.count; ++i) {
    box.least[i] = std::min(box.least[i], motion_.to[i]);
    box.most[i] = std::max(box.most[i], motion_.to[i]);
  }
  if (straight()) return box;
  const auto widen = [&](std::size_t axis, double least, double most) {
    if ((rolled_ >> axis & 1U) != 0) return;
    box.least[axis] = std::min(box.least[axis], least);
    box.most[axis] = std::max(box.most[axis], most);
  };
  if (surface_ == PathSurface::polar) {
    PolarAxes low, high;
    polar().extremes(low, high);
    widen(first_, low.linear, high.linear);
    widen(second_, low.rotary, high.rotary);
  } else {
    const Box2 flat = flat_.box();
    const Vec2 least = in_axes(flat.least), most = in_axes(flat.most);
    widen(first_, least.x, most.x);
    widen(second_, least.y, most.y);
  }
  for (std::size_t n = 0; following_ != 0 && n < motion_.detail->followers.size(); ++n) {
    const auto [axis, master, sign] = motion_.detail->followers[n];
    const double least_travel = box.least[master] - from_[master], max_travel = box.most[master] - from_[master];
    const double rest = travel(axis) - sign * travel(master);
    box.least[axis] = from_[axis] + std::min(sign * least_travel, sign * max_travel) + std::min(rest, 0.0);
    box.most[axis] = from_[axis] + std::max(sign * least_travel, sign * max_travel) + std::max(rest, 0.0);
  }
  return box;
}

int Curve::pieces(double chord) const {
  if (straight()) return 1;
  return surface_ == PathSurface::polar ? polar().pieces(chord) : flat_.pieces(chord);
}

}  // namespace kadr
