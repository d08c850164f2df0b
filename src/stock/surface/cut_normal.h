#pragma once
// The normal of a surface cut by a sweep: the normal of the tool where it touched the point. Used by stock/surface/crossings.
//
// A body of a tool is convex, and so is its distance from a point as a function of the path. The tool touched where this is least,
// and its normal there is the surface's. If the minimum is at a corner of the function, at a rim of the tool, the rim swept the
// surface: the normal is between both normals, perpendicular to the path.
//
//   law  perpendicular to the directions in which the distance from the swept tool (stock/tool/round_solid.h) is constant
//        (tests/stock/surface_test)

#include <vector>

#include "stock/stock.h"

namespace kadr {

/// The outline of a convex body of a tool as faces of revolution; its distance from a point is the greatest distance from these.
struct BodyFaces {
  struct Side {
    RoundSolid::Form form;
    double radius, height;            // a point of the face; for a ball or torus the centre of its circle
    double normal_radial, normal_up;  // for a cylinder or cone
    double circle;                    // radius of the circle of a ball or torus
  };
  explicit BodyFaces(const ConvexBody& body);

  double bottom, top, widest;
  bool ball;  // a ball end, with or without a cylinder above
  std::vector<Side> sides;
};

/// The bodies of a tool.
using ToolFaces = std::vector<BodyFaces>;
ToolFaces faces_of(const ToolShape& tool);

/// A point where a lattice line of the family crosses the surface.
struct CutPlace {
  Vec3 at;  // mm from the lattice's corner
  int family;
  bool leaves;  // the material is before the point on the line
};

/// True if the sweep has cut a surface there that the line crosses.
///   ends  directions, for a sweep with a tilted tool
bool cut_at(const KeptSweep& sweep, const ToolFaces& tool, const CutPlace& place, const LeanEnds* ends = nullptr);

/// Returns the outward normal of the remaining material.
Vec3 cut_normal(const KeptSweep& sweep, const ToolFaces& tool, const CutPlace& place, const LeanEnds* ends = nullptr);

}  // namespace kadr
