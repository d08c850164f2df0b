#pragma once
// Random motions for the tests of the rooms after `control`: lines, arcs, helices, spirals, polar and cylindrical interpolation, with
// and without a rotated frame. Axes are X, Y, Z, C, and V and W, which may be synchronous to X and V.

#include <rapidcheck.h>

#include "action/curve.h"
#include "action/tool_position.h"
#include "actions.h"
#include "any_number.h"

namespace kadr::test {

struct Moved {
  AxisRoles roles;
  ToolPosition from;
  Motion motion;
};

/// Returns a random start: work coordinates near the origin; no frame yet.
inline Moved any_start() {
  Moved moved{AxisRoles::of({"X", "Y", "Z", "C", "V", "W"}, 8), {}, {}};
  moved.from.work = {any_number(-50, 50), any_number(-50, 50), any_number(-50, 50), any_number(0, 360), any_number(-50, 50)};
  return moved;
}

/// Computes the machine coordinates through a frame that is shifted at random and, if `may_turn`, sometimes rotated.
inline void lay_frame(Moved& moved, bool may_turn) {
  if (may_turn && *rc::gen::arbitrary<bool>()) {
    FrameTurn turn;
    const SinCos a = sincos_deg(any_number(-180, 180));
    turn.rows = {Vec3{a.cos, -a.sin, 0}, Vec3{a.sin, a.cos, 0}, Vec3{0, 0, 1}};
    moved.from.turn = std::make_shared<const FrameTurn>(turn);
  }
  const Axes shift{any_number(-20, 20), any_number(-20, 20), any_number(-20, 20), 0};
  moved.from.machine = turned(moved.from.turn.get(), moved.from.work);
  moved.motion.machine = turned(moved.from.turn.get(), moved.motion.to);
  for (std::size_t i = 0; i < moved.roles.count; ++i) moved.from.machine[i] += shift[i], moved.motion.machine[i] += shift[i];
}

/// Makes V copy the travel of X, and W the travel of V in the same or the opposite direction.
inline void let_follow(Moved& moved) {
  constexpr std::uint8_t v = 4, w = 5;
  auto detail = moved.motion.detail ? std::make_shared<MotionDetail>(*moved.motion.detail) : std::make_shared<MotionDetail>();
  detail->followers = {{v, 0, -1}, {w, v, *rc::gen::element(1.0, -1.0)}};
  for (const Follower& f : detail->followers) {
    const double travel = f.sign * (moved.motion.machine[f.master] - moved.from.machine[f.master]);
    moved.motion.machine[f.axis] = moved.from.machine[f.axis] + travel;
    moved.motion.to[f.axis] = moved.from.work[f.axis] + travel;
  }
  moved.motion.detail = std::move(detail);
}

inline Moved any_line() {
  Moved moved = any_start();
  moved.motion = straight(MotionKind::feed, {any_number(-50, 50), any_number(-50, 50), any_number(-50, 50)}, 100);
  moved.motion.to[3] = any_number(0, 360);
  moved.motion.to[4] = moved.from.work[4];
  lay_frame(moved, true);
  return moved;
}

/// Returns the end of an arc that begins at `arm` from the centre; its radius at the end is `growth` times the radius at the start.
inline Vec2 arc_end(Vec2 center, Vec2 arm, double turns, double growth) { return center + growth * rotated(arm, 360 * turns); }

inline Moved any_arc() {
  Moved moved = any_start();
  const bool ccw = *rc::gen::arbitrary<bool>();
  const auto plane = *rc::gen::element(Plane::xy, Plane::zx, Plane::yz);
  const PlaneAxes axes = axes_of(plane);
  const double turns = any_number(0, 2) + 0.01, growth = *rc::gen::element(1.0, 1.0, 0.5, 1.7);
  const Vec2 arm{any_number(1, 40), any_number(-40, 40)};
  const Vec2 start{moved.from.work[axes.first], moved.from.work[axes.second]};
  Motion& m = moved.motion = arc(ccw ? MotionKind::arc_ccw : MotionKind::arc_cw, {}, {}, turns, plane);
  m.center = start - arm;
  m.to = moved.from.work;
  const Vec2 end = arc_end(m.center, arm, ccw ? turns : -turns, growth);
  m.to[axes.first] = end.x;
  m.to[axes.second] = end.y;
  m.to[axes.normal] += *rc::gen::element(0.0, 7.0, -12.0);
  lay_frame(moved, true);
  return moved;
}

/// Returns a line in the plane of polar interpolation (X and C) that misses the rotation centre.
inline Moved any_polar() {
  Moved moved = any_start();
  MotionDetail detail;
  detail.surface = PathSurface::polar;
  detail.flat_from = {any_number(5, 50), any_number(-50, 50)};
  detail.flat_to = {any_number(-50, 50), any_number(5, 50)};
  const FlatPath flat = FlatPath::line(detail.flat_from, detail.flat_to);
  const PolarPath path(flat, 1, 0, moved.from.work[3]);
  moved.from.work[0] = path.at(0).linear;
  Motion& m = moved.motion = straight(MotionKind::feed, {path.at(1).linear, moved.from.work[1], moved.from.work[2]}, 100);
  m.to[4] = moved.from.work[4];
  m.to[3] = path.at(1).rotary;
  m.second = 3;
  m.detail = std::make_shared<MotionDetail>(detail);
  lay_frame(moved, false);
  return moved;
}

/// Returns an arc on a cylinder about C; C is the first axis of the plane, Z the second.
inline Moved any_cylinder() {
  Moved moved = any_start();
  MotionDetail detail;
  detail.surface = PathSurface::cylinder;
  detail.radius = any_number(5, 60);
  const double unit = detail.radius * rad_per_deg;
  detail.flat_from = {moved.from.work[3] * unit, moved.from.work[2]};
  const Vec2 arm{any_number(1, 30), any_number(-30, 30)};
  const double turns = any_number(0, 1) * 0.9 + 0.01;
  const Vec2 center = detail.flat_from - arm;
  detail.flat_to = arc_end(center, arm, turns, 1);
  Motion& m = moved.motion = straight(MotionKind::arc_ccw, {}, 100);
  m.first = 3;
  m.second = 2;
  m.center = {center.x / unit, center.y};
  m.turns = turns;
  m.to = moved.from.work;
  m.to[3] = detail.flat_to.x / unit;
  m.to[2] = detail.flat_to.y;
  m.detail = std::make_shared<MotionDetail>(detail);
  lay_frame(moved, false);
  return moved;
}

inline Moved any_own_motion() {
  switch (*rc::gen::inRange(0, 4)) {
    case 0: return any_line();
    case 1: return any_polar();
    case 2: return any_cylinder();
    default: return any_arc();
  }
}

inline Moved any_motion() {
  Moved moved = any_own_motion();
  if (*rc::gen::arbitrary<bool>()) let_follow(moved);
  return moved;
}

}  // namespace kadr::test
