#pragma once
// RoundSolid: a convex body of revolution about the tool's axis; tools are built from these.

#include <cstdint>
#include <vector>

#include "config/tool_geometry.h"
#include "stock/tool/insert_body.h"

namespace kadr {

/// Heights are above the tool's tip, mm.
struct RoundSolid {
  enum class Form : std::uint8_t {
    cylinder,  // `top_radius` from `bottom` to `top`
    cone,      // from `bottom_radius` at `bottom` to `top_radius` at `top`
    ball,      // the lower half of a ball of `top_radius`; `top` is the height of its centre
    torus,     // a flat end of `bottom_radius`, then a quarter circle of radius `top` - `bottom` out to `top_radius`
  };
  Form form = Form::cylinder;
  double bottom = 0, top = 0;
  double bottom_radius = 0, top_radius = 0;

  double widest() const { return bottom_radius > top_radius ? bottom_radius : top_radius; }
};

/// The part of the tool that touches the material.
enum class ToolPart : std::uint8_t { cutting, beyond_flutes, shank, holder };
inline constexpr int tool_parts = 4;

/// Solids whose union is convex, so that a straight line meets the volume swept along a straight path in one interval.
struct ConvexBody {
  ToolPart part = ToolPart::cutting;
  std::vector<RoundSolid> solids;

  double bottom() const;
  double top() const;
  double widest() const;
};

/// A tool as the material meets it: cutting part, shank and holder.
struct ToolShape {
  ToolGeometry geometry;
  std::vector<ConvexBody> bodies;  // the cutting part's first
  std::vector<InsertBody> insert;  // for a turning tool, which has no other bodies; the cutting part's first

  bool turns() const { return !insert.empty(); }
};

/// Builds the solids of each kind of tool (docs/commands/cut.md, "Tools").
///   pre  told_fault(geometry) is empty
ToolShape shape_of(const ToolGeometry& geometry);
/// Returns a turning tool without its insert. It stands for the tool while the insert is in a helical groove.
ToolShape holder_of(const ToolShape& tool);

/// Distance of a point from a solid, and the direction in which the distance grows, in the half plane of radius and height above the
/// tip.
struct Away {
  double distance = 0;  // mm; negative inside
  double radial = 0, axial = 0;
};
Away away_from(const RoundSolid& solid, double radius, double height);

}  // namespace kadr
