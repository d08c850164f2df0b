// Transform: scale, mirror image and rotation; converts programmed coordinates to work coordinates and back (Mach3 10.7, NCT 16).

#include <algorithm>
#include <cmath>

#include "control/state/control_state.h"

namespace kadr {

Transform::Transform() {
  scale.fill(1);
  scale_shift.fill(0);
  added.fill(0);
  mirror.fill(1);
}

void Transform::refresh() {
  const auto is_one = [](double x) { return x == 1; };
  identity = rotation == 0 && std::all_of(scale.begin(), scale.end(), is_one) &&
             std::all_of(mirror.begin(), mirror.end(), [](std::int8_t m) { return m == 1; }) &&
             std::all_of(added.begin(), added.end(), [](double x) { return x == 0; });
  turn_ = sincos_deg(rotation);
}

/// Rotates a point about the rotation centre, in place.
void Transform::turn(Axes& at, SinCos by) const {
  if (rotation == 0) return;
  const Vec2 arm = Vec2{at[first], at[second]} - rotation_center;
  at[first] = rotation_center.x + (by.cos * arm.x - by.sin * arm.y);
  at[second] = rotation_center.y + (by.sin * arm.x + by.cos * arm.y);
}

Axes Transform::to_work(const Axes& programmed) const {
  Axes at = programmed;
  if (!turned_last) turn(at, turn_);
  for (std::size_t a = 0; a < max_axes; ++a) at[a] = at[a] * scale[a] + scale_shift[a];
  if (turned_last) turn(at, turn_);
  for (std::size_t a = 0; a < max_axes; ++a) at[a] = at[a] * mirror[a] + added[a];
  return at;
}

Axes Transform::to_programmed(const Axes& work) const {
  const SinCos back{-turn_.sin, turn_.cos};
  Axes at;
  for (std::size_t a = 0; a < max_axes; ++a) at[a] = (work[a] - added[a]) * mirror[a];
  if (turned_last) turn(at, back);
  for (std::size_t a = 0; a < max_axes; ++a) at[a] = (at[a] - scale_shift[a]) / scale[a];
  if (!turned_last) turn(at, back);
  return at;
}

AxisMask Transform::moved_with(AxisMask named) const {
  const AxisMask both = AxisMask{1} << first | AxisMask{1} << second;
  return rotation != 0 && (named & both) != 0 ? named | both : named;
}

bool Transform::leaves(PlaneAxes plane) const {
  const auto turned = [&](std::size_t axis) { return axis == first || axis == second; };
  return rotation != 0 && turned(plane.first) != turned(plane.second);
}

bool Transform::distorts(PlaneAxes plane) const { return std::fabs(scale[plane.first]) != std::fabs(scale[plane.second]); }

Vec2 Transform::to_work(Vec2 programmed, PlaneAxes plane) const {
  Axes at{};
  at[plane.first] = programmed.x;
  at[plane.second] = programmed.y;
  at = to_work(at);
  return {at[plane.first], at[plane.second]};
}

Vec2 Transform::direction(Vec2 vector, PlaneAxes plane) const {
  Transform rigid = *this;
  for (std::size_t a = 0; a < max_axes; ++a) rigid.scale[a] = scale[a] < 0 ? -1 : 1;
  rigid.scale_shift.fill(0);
  rigid.added.fill(0);
  rigid.rotation_center = {};
  return rigid.to_work(vector, plane);
}

double Transform::corner_scale(PlaneAxes plane) const { return (std::fabs(scale[plane.first]) + std::fabs(scale[plane.second])) / 2; }

double Transform::radius_scale(PlaneAxes plane) const { return std::fabs(scale[plane.first]); }

}  // namespace kadr
