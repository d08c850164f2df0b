#pragma once
// RoundSolid: a solid of revolution about the tool's axis. Tools are built from convex unions of such solids.

#include <cstdint>
#include <vector>

#include "config/tools/tool_geometry.h"
#include "stock/tool/insert_body.h"

namespace kadr {

/// A solid of revolution. Heights are measured from the tool's tip, in mm.
struct RoundSolid {
  enum class Form : std::uint8_t {
    cylinder,  // a cylinder of radius `top_radius` from the height `bottom` to the height `top`
    cone,      // a cone from `bottom_radius` at the height `bottom` to `top_radius` at the height `top`
    ball,      // the lower half of a sphere of radius `top_radius`; `top` is the height of the sphere's centre
    torus,     // a flat end of radius `bottom_radius`, then a quarter circle of radius `top` - `bottom` up to the radius `top_radius`
  };
  Form form = Form::cylinder;
  double bottom = 0, top = 0;
  double bottom_radius = 0, top_radius = 0;

  double widest() const { return bottom_radius > top_radius ? bottom_radius : top_radius; }
};

/// The parts of a tool that can touch the material.
enum class ToolPart : std::uint8_t { cutting, beyond_flutes, shank, holder };
inline constexpr int tool_parts = 4;

/// A union of solids that is convex. So a straight line has only one interval in common with the volume that the union sweeps along a
/// straight path.
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
  std::vector<ConvexBody> bodies;  // bodies of the tool; the cutting part comes first
  std::vector<InsertBody> insert;  // outlines of a turning tool; the cutting part comes first; a turning tool has no `bodies`

  bool turns() const { return !insert.empty(); }
};

/// Returns the solids that each type of tool consists of (docs/commands/cut.md, "Tools").
///   pre  tool_fault_message(geometry) is empty
ToolShape shape_of(const ToolGeometry& geometry);
/// Returns a turning tool without its insert. This tool replaces the whole tool while the insert is in a helical groove (a thread).
ToolShape holder_of(const ToolShape& tool);

/// The distance of a point from a solid, and the direction in which this distance grows. The direction is in the half plane of radius and
/// height above the tip.
struct Away {
  double distance = 0;  // distance in mm; negative inside the solid
  double radial = 0, axial = 0;
};
Away away_from(const RoundSolid& solid, double radius, double height);

}  // namespace kadr
