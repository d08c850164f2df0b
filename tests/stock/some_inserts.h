#pragma once
// Random inserts and paths for the tests of turning, and the distance of a point from the rings that the inserts sweep.

#include "config/tools/tool_library.h"
#include "stock/some_tools.h"

namespace kadr {

inline ToolGeometry insert(int tip_x, int tip_z, double angle, double corner, double edge) {
  ToolGeometry g;
  g.kind = ToolKind::turning;
  g.angle = angle, g.corner = corner, g.flutes = edge;
  g.insert.tip_x = tip_x, g.insert.tip_z = tip_z;
  complete(g);
  return g;
}

/// Returns an insert of any form; its profile is a star about a point, and mostly not convex.
inline ToolShape some_insert(Chance& chance) {
  ToolGeometry g;
  g.kind = ToolKind::turning;
  g.insert.tip_x = chance.below(3) - 1, g.insert.tip_z = chance.below(3) - 1;
  g.corner = chance.below(4) == 0 ? 0 : chance.between(0.05, 1.2);
  g.flutes = chance.between(4, 9);
  switch (chance.below(4)) {
    case 0:
      g.angle = chance.between(35, 120);
      if (chance.below(2) == 0) g.insert.lead = chance.between(-40, 160);
      break;
    case 1: g.insert.width = 2 * g.corner + (chance.below(4) == 0 ? 0 : chance.between(0.2, 3)) + 1e-3; break;
    case 2: g.corner = chance.between(0.2, 4); break;
    default: {
      const int points = 3 + chance.below(5);
      const InsertPoint middle{chance.between(-3, 3), chance.between(-3, 3)};
      for (int i = 0; i < points; ++i) {
        const double angle = (i + chance.between(0, 0.8)) * 2 * pi / points, far = chance.between(0.3, 4);
        g.insert.profile.push_back({middle.x + far * std::cos(angle), middle.z + far * std::sin(angle)});
      }
    }
  }
  if (chance.below(3) == 0 && g.insert.profile.empty()) g.length = g.flutes + 2;
  if (chance.below(3) == 0) g.insert.holder = {{5, -2}, {9, 3}};
  complete(g);
  return tool_fault_message(g).empty() ? shape_of(g) : shape_of(insert(-1, -1, 80, 0.4, 5));
}

/// Returns a path along an axis, at any slant, without motion, from far away, or across the axis.
inline Sweep some_sweep(Chance& chance) {
  const Vec3 through{chance.between(-12, 12), 0, chance.between(-4, 12)};
  const double far = std::pow(10, chance.between(-3, chance.below(8) == 0 ? 4 : 1.3)), angle = chance.between(0, 2 * pi);
  Vec3 travel{far * std::cos(angle), 0, far * std::sin(angle)};
  switch (chance.below(7)) {
    case 0: travel.x = 0; break;
    case 1: travel.z = 0; break;
    case 2: travel.x *= 1e-5; break;
    case 3: travel.z *= 1e-5; break;
    case 4: travel = {}; break;
    default: break;
  }
  const Vec3 from = through - chance.between(0, 1) * travel;
  return {from, from + travel, 0, false};
}

/// Returns the greatest distance, over all directions, from the planes behind which the hull of the swept corners lies. Directions are
/// tried in steps, then each peak is refined by golden sections.
inline double from_hull(const InsertBody& body, const Sweep& sweep, double x, double z) {
  constexpr int steps = 720;
  constexpr double golden = 0.6180339887498949;
  const auto beyond = [&](double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    double most = -1e30;
    for (const InsertCorner& corner : body.corners) most = std::max(most, corner.centre.x * c + corner.centre.z * s + corner.radius);
    most += std::max(sweep.from.x * c + sweep.from.z * s, sweep.to.x * c + sweep.to.z * s);
    return x * c + z * s - most;
  };
  // Every peak is refined: on the steps, the peak of a thin body's other side may be higher although it is in fact lower.
  const double step = 2 * pi / steps;
  double best = -1e30;
  const auto climb = [&](double at) {
    double low = at - step, high = at + step;
    for (int i = 0; i < 60; ++i) {
      const double a = high - golden * (high - low), b = low + golden * (high - low);
      (beyond(a) > beyond(b) ? high : low) = beyond(a) > beyond(b) ? b : a;
    }
    best = std::max({best, beyond(at), beyond(0.5 * (low + high))});
  };
  double before = beyond(-step), here = beyond(0);
  for (int i = 0; i < steps; ++i) {
    const double next = beyond((i + 1) * step);
    if (here >= before && here >= next) climb(i * step);
    before = here, here = next;
  }
  const double across = std::atan2(sweep.to.z - sweep.from.z, sweep.to.x - sweep.from.x) + pi / 2;  // the peak is steep if the path is long
  climb(across), climb(across + pi);
  return best;
}

/// Returns the distance of a point from the rings; negative inside one.
inline double from_rings(const ToolShape& tool, const Sweep& sweep, Vec3 at) {
  double nearest = 1e30;
  for (const InsertBody& body : tool.insert)
    for (const double side : {1.0, -1.0}) nearest = std::min(nearest, from_hull(body, sweep, side * std::hypot(at.x, at.y), at.z));
  return nearest;
}

}  // namespace kadr
