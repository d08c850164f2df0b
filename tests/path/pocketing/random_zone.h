#pragma once
// Random zones: star-shaped outlines of lines and arcs, islands, open sides. Passages may be exactly as wide as the tool.

#include <rapidcheck.h>

#include <cmath>

#include "base/vec.h"
#include "config/drawing/drawing.h"

namespace kadr::test {

inline double share(int thousandths) { return thousandths / 1000.0; }

/// Returns a star around `centre`: its corners are at even angles, their radii in [least, most]; some sides are arcs, some are open.
inline Edges random_star(Vec2 centre, double least, double most, bool may_be_open) {
  const int corners = *rc::gen::inRange(3, 9);
  std::vector<Vec2> points;
  for (int i = 0; i < corners; ++i) {
    const double radius = least + (most - least) * share(*rc::gen::inRange(0, 1001));
    const SinCos turn = sincos_deg(360.0 * i / corners);
    points.push_back(centre + radius * Vec2{turn.cos, turn.sin});
  }
  Edges loop;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double bulge = *rc::gen::inRange(0, 3) == 0 ? share(*rc::gen::inRange(-100, 201)) : 0;
    loop.push_back({points[i], points[(i + 1) % points.size()], bulge, may_be_open && *rc::gen::inRange(0, 4) == 0});
  }
  return loop;
}

inline Edges circle(Vec2 centre, double radius) {
  const Vec2 a = centre - Vec2{radius, 0}, b = centre + Vec2{radius, 0};
  return {{a, b, 1}, {b, a, 1}};
}

/// Returns an outline about 60 mm wide with up to three islands around its middle.
inline Edges random_drawing(bool may_be_open) {
  Edges edges = random_star({}, 18, 40, may_be_open);
  const int islands = *rc::gen::inRange(0, 4);
  for (int i = 0; i < islands; ++i) {
    const Vec2 at = rotated({7, 0}, 120.0 * i);
    const Edges island =
        *rc::gen::inRange(0, 2) == 0 ? circle(at, 0.5 + share(*rc::gen::inRange(0, 3000))) : random_star(at, 1, 3.5, false);
    edges.insert(edges.end(), island.begin(), island.end());
  }
  return edges;
}

}  // namespace kadr::test
