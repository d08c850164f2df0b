#pragma once
// InsertSweep: the area that a convex outline sweeps along straight segments in the half plane through the axis of a spinning part. It is
// used by session/cutting/turned_cutting.
//
// A point of the half plane is a Vec2: x is the signed radius, y is Z, mm. The swept area of a convex outline P along d is the sum of
// Minkowski P + [0, d]. It is convex too:
//
//      s2 ┌────────┐ s2 + d     s1, s2: the points of the outline that are farthest to the right and to the left of d;
//      ◟ P        ◝ P + d      the back of the outline stays, its front is shifted by d
//      s1 └────────┘ s1 + d
//
// s1 and s2 are exact, so a wall that is parallel to a line of the path is exact. The rest of a round nose is replaced by chords.

#include <vector>

#include "base/vec.h"
#include "stock/tool/round_solid.h"

namespace kadr {

/// A closed polygon in the half plane: x is the radius, y is Z, mm.
using TurnedPolygon = std::vector<Vec2>;

class InsertSweep {
 public:
  /// `chord`: greatest deviation of the chords from the nose, mm. The chords lie inside the nose.
  InsertSweep(const InsertBody& body, double chord);

  ToolPart part() const { return body_.part; }
  /// Returns the area that the outline sweeps while the programmed point moves from `from` to `to`; the outline itself if both are equal.
  ///   returns  a convex polygon, counter-clockwise
  ///   law      each point of the area is at most `chord` farther inside than the true boundary   (tests/stock/turned_stock_test)
  TurnedPolygon swept(Vec2 from, Vec2 to) const;

 private:
  Vec2 farthest(Vec2 direction) const;
  std::size_t farthest_corner(Vec2 direction) const;

  InsertBody body_;
  TurnedPolygon outline_;  // the outline with chords instead of its arcs
};

/// Returns the outlines of a tool in the half plane: those of a turning tool, or those of a tool of revolution that stands on the axis,
/// such as a drill in the turret. The cutting part comes first.
std::vector<InsertSweep> insert_sweeps(const ToolShape& tool, double chord);

}  // namespace kadr
