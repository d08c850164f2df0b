#pragma once
// RoundSolid: the convex bodies of revolution about the tool's axis that tools are put together from.

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

/// What of the tool touches the material.
enum class ToolPart : std::uint8_t { cutting, beyond_flutes, shank, holder };
inline constexpr int tool_parts = 4;

/// Solids whose union is convex: a straight line meets what they sweep along a straight way in one interval.
struct ConvexBody {
  ToolPart part = ToolPart::cutting;
  std::vector<RoundSolid> solids;

  double bottom() const;
  double top() const;
  double widest() const;
};

/// A tool for the material: cutting part, shank and holder.
struct ToolShape {
  ToolGeometry geometry;
  std::vector<ConvexBody> bodies;  // the cutting part's first
  std::vector<InsertBody> insert;  // of a turning tool, which has no others; the cutting part's first

  bool turns() const { return !insert.empty(); }
};

/// By the kinds of design.md 10.
///   pre  fault_of(geometry) is empty
ToolShape shape_of(const ToolGeometry& geometry);
/// Nothing of a turning tool but its holder: what it is to the material while its insert is in a groove that goes round in a helix.
ToolShape holder_of(const ToolShape& tool);

/// Distance of a point from a solid, and the direction in which it grows, in the half plane of radius and height above the tip.
struct Away {
  double distance = 0;  // below 0: inside, mm
  double radial = 0, axial = 0;
};
Away away_from(const RoundSolid& solid, double radius, double height);

}  // namespace kadr
