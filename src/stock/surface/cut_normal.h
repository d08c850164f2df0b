#pragma once
// Computes the normal of a surface that a sweep has cut, which is the normal of the tool where the tool touched the surface. Used by
// stock/surface/crossings.
//
// Each solid body of a tool is convex, so the distance of a point from the moving body is a convex function of the position on the path.
// The tool touched the point where this distance is least, and the tool's normal in that position is the normal of the surface. The
// function may have its minimum at a corner, where the nearest point of the tool is on the edge circle between two faces. The edge circle
// has then cut the surface, and the normal is between the normals of the two faces, perpendicular to the path.
//
//   law  the normal is perpendicular to every direction in which the distance from the swept tool (stock/tool/round_solid.h) is constant
//        (tests/stock/surface_test)

#include <vector>

#include "stock/stock.h"

namespace kadr {

/// The faces of revolution of a convex body of a tool. The distance of a point from the body is the greatest of the distances from these
/// faces.
struct BodyFaces {
  struct Side {
    RoundSolid::Form form;
    double radius, height;            // a point of the face, mm; for a ball or torus, the centre of the generating circle
    double normal_radial, normal_up;  // components of the normal of a cylinder or cone
    double circle;                    // radius in mm of the generating circle of a ball or torus
  };
  explicit BodyFaces(const ConvexBody& body);

  double bottom, top, widest;
  bool ball;  // true for a ball end, with or without a cylinder above it
  std::vector<Side> sides;
};

/// The bodies of a tool, each as its faces.
using ToolFaces = std::vector<BodyFaces>;
ToolFaces faces_of(const ToolShape& tool);

/// A crossing: a point where a lattice line of the direction `family` crosses the surface of the material.
struct CutPlace {
  Vec3 at;  // position of the point in mm, from the lattice's corner
  int family;
  bool leaves;  // true if the line leaves the material at this point, false if the line enters the material
};

/// Returns true if the sweep has cut a surface at the crossing `place`, and the lattice line crosses this surface.
///   ends  directions of the tool; nullptr if the tool is not tilted
bool cut_at(const KeptSweep& sweep, const ToolFaces& tool, const CutPlace& place, const TiltedEnds* ends = nullptr);

/// Returns the outward normal of the remaining material at the crossing `place`.
Vec3 cut_normal(const KeptSweep& sweep, const ToolFaces& tool, const CutPlace& place, const TiltedEnds* ends = nullptr);

}  // namespace kadr
