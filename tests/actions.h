#pragma once
// Builds actions for the tests of the rooms after `control`: motions in one work coordinate system.

#include "control/state/control_state.h"

namespace kadr::test {

inline Motion straight(MotionKind kind, Vec3 to, double feed = 0) {
  Motion m{};
  m.kind = kind;
  m.to = {to.x, to.y, to.z};
  m.machine = m.to;
  m.feed = feed;
  return m;
}

/// `center` has all three coordinates; the one normal to the plane is ignored.
inline Motion arc(MotionKind kind, Vec3 to, Vec3 center, double turns, Plane plane = Plane::xy) {
  Motion m = straight(kind, to, 100);
  const PlaneAxes axes = axes_of(plane);
  const std::array<double, 3> all{center.x, center.y, center.z};
  m.center = {all[axes.first], all[axes.second]};
  m.turns = turns;
  m.first = static_cast<std::uint8_t>(axes.first);
  m.second = static_cast<std::uint8_t>(axes.second);
  return m;
}

inline Action action(const Motion& motion, std::uint32_t line = 1) {
  Action a{};
  a.origin.line = line;
  a.origin.column = 1;
  a.what = motion;
  return a;
}

}  // namespace kadr::test
