#pragma once
// The normal of a surface that a sweep has cut: that of the tool where it touched the place. For stock/surface/crossings.
//
// A body of a tool is convex, and so is the distance of a place from it over the way. Where that is least the tool touched: its normal
// there is the surface's. Where the least is a kink, at a rim of the tool, the surface is that which the rim sweeps: between both normals,
// upright to the way.
//
//   law  upright to what the distance from the swept tool (stock/tool/round_solid.h) is level along   (tests/stock/surface_test)

#include <vector>

#include "stock/stock.h"

namespace kadr {

/// The outline of a convex body of a tool, as faces of revolution; its distance from a place is the greatest of theirs.
struct BodyFaces {
  struct Side {
    RoundSolid::Form form;
    double radius, height;            // a place of it; of a ball or torus the middle of its circle
    double normal_radial, normal_up;  // of a cylinder or cone
    double circle;                    // radius of the circle
  };
  explicit BodyFaces(const ConvexBody& body);

  double bottom, top, widest;
  bool ball;  // with or without a cylinder above
  std::vector<Side> sides;
};

/// The bodies of a tool.
using ToolFaces = std::vector<BodyFaces>;
ToolFaces faces_of(const ToolShape& tool);

/// A place where a lattice line of the family goes through the surface.
struct CutPlace {
  Vec3 at;  // mm from the lattice's corner
  int family;
  bool leaves;  // the material lies before it on the line
};

/// Whether the sweep has cut a surface there that the line goes through.
///   ends  of a sweep that leans
bool cut_at(const KeptSweep& sweep, const ToolFaces& tool, const CutPlace& place, const LeanEnds* ends = nullptr);

/// Outward, of what is left.
Vec3 cut_normal(const KeptSweep& sweep, const ToolFaces& tool, const CutPlace& place, const LeanEnds* ends = nullptr);

}  // namespace kadr
