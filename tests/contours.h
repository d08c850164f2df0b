#pragma once
// Contours for the tests of path: motions that follow each other. Each begins in
// the direction in which the previous one ended, unless the contour turns there.

#include <algorithm>
#include <cmath>
#include <vector>

#include "action/curve.h"
#include "actions.h"
#include "any_number.h"
#include "base/tolerance.h"
#include "path/compensation/radius_compensation.h"

namespace kadr::test {

inline const AxisRoles xyz = AxisRoles::of({"X", "Y", "Z"}, 0);

/// A contour with its approach and departure, each a motion of its own; all motions are on the same side.
struct Contour {
  std::vector<Motion> motions;
  Vec2 at, direction{1, 0};

  Motion& add(Motion m, std::int8_t side, double radius) {
    m.named = 3;
    m.machine = m.to;
    m.side = side;
    m.tool_radius = radius;
    at = {m.to[0], m.to[1]};
    motions.push_back(m);
    return motions.back();
  }
  Motion& line(double length, std::int8_t side, double radius) {
    const Vec2 to = at + length * direction;
    return add(straight(MotionKind::feed, {to.x, to.y, 0}), side, radius);
  }
  Motion& arc(double radius_of_arc, double turns, std::int8_t side, double radius) {
    const Vec2 center = at + (turns > 0 ? radius_of_arc : -radius_of_arc) * left_of(direction);
    const Vec2 to = center + rotated(at - center, 360 * turns);
    direction = rotated(direction, 360 * turns);
    return add(test::arc(turns > 0 ? MotionKind::arc_ccw : MotionKind::arc_cw, {to.x, to.y, 0}, {center.x, center.y, 0}, std::fabs(turns)),
               side, radius);
  }
};

inline constexpr double sampling = 1;  // greatest distance between two samples, mm

/// Samples points along motions that follow each other.
inline std::vector<Vec2> sampled(const std::vector<Motion>& motions, Axes from) {
  std::vector<Vec2> points;
  for (const Motion& m : motions) {
    const Curve curve(xyz, from, m);
    const int pieces = static_cast<int>(std::min(20 + curve.length() / sampling, 5000.0));
    for (int i = 0; i <= pieces; ++i) {
      const Axes at = curve.at(static_cast<double>(i) / pieces);
      points.push_back({at[0], at[1]});
    }
    from = m.to;
  }
  return points;
}

}  // namespace kadr::test
