#pragma once
// RoundSolid: a solid of revolution about the tool's axis. Tools are built from convex unions of such solids.

#include <cstdint>
#include <vector>

#include "config/tools/tool_geometry.h"
#include "stock/tool/insert_body.h"

namespace kadr {

/// Heights are measured from the tool's tip, mm.
struct RoundSolid {
  enum class Form : std::uint8_t {
    cylinder,  // `top_radius` from `bottom` to `top`
    cone,      // from `bottom_radius` at `bottom` to `top_radius` at `top`
    ball,      // the lower half of a sphere of radius `top_radius`; `top` is the height of the sphere's centre
    torus,     // a flat end of radius `bottom_radius`, then a quarter circle of radius `top` - `bottom` out to the radius `top_radius`
  };
  Form form = Form::cylinder;
  double bottom = 0, top = 0;
  double bottom_radius = 0, top_radius = 0;

  double widest() const { return bottom_radius > top_radius ? bottom_radius : top_radius; }
};

/// The sections of a tool that can touch the material.
enum class ToolPart : std::uint8_t { cutting, beyond_flutes, shank, holder };
inline constexpr int tool_parts = 4;

/// Solids whose union is convex. So a straight line has one interval in common with the volume that the union sweeps along a straight
/// path.
struct ConvexBody {
  ToolPart part = ToolPart::cutting;
  std::vector<RoundSolid> solids;

  double bottom() const;
  double top() const;
  double widest() const;
};

/// A tool as the cutting simulation uses it: cutting part, shank and holder.
struct ToolShape {
  ToolGeometry geometry;
  std::vector<ConvexBody> bodies;  // the body of the cutting part is the first
  std::vector<InsertBody> insert;  // outlines of a turning tool, the cutting part first; a turning tool has no `bodies`

  bool turns() const { return !insert.empty(); }
};

/// Builds the solids for each type of tool (docs/commands/cut.md, "Tools").
///   pre  tool_fault_message(geometry) is empty
ToolShape shape_of(const ToolGeometry& geometry);
/// Returns a turning tool without its insert. It replaces the tool while the insert is in a helical groove (a thread).
ToolShape holder_of(const ToolShape& tool);

/// The distance of a point from a solid, and the direction in which this distance grows, in the half plane of radius and height above
/// the tip.
struct Away {
  double distance = 0;  // mm; negative inside the solid
  double radial = 0, axial = 0;
};
Away away_from(const RoundSolid& solid, double radius, double height);

}  // namespace kadr
