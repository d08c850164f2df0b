// Builds the solids for each type of tool (docs/commands/cut.md, "Tools").

#include <algorithm>
#include <cmath>

#include "base/vec.h"
#include "stock/tool/round_solid.h"

namespace kadr {
namespace {

using Form = RoundSolid::Form;

RoundSolid cylinder(double bottom, double top, double radius) { return {Form::cylinder, bottom, top, radius, radius}; }

/// Returns the solid between two consecutive points of an outline.
RoundSolid section(const ProfilePoint& a, const ProfilePoint& b, double above) {
  const double low = a.diameter / 2, high = b.diameter / 2;
  return {low == high ? Form::cylinder : Form::cone, above + a.height, above + b.height, low, high};
}

/// Adds each part of an outline as a body of its own, because the union of these parts need not be convex.
void add_outline(std::vector<ConvexBody>& bodies, ToolPart part, const std::vector<ProfilePoint>& outline, double above) {
  for (std::size_t i = 1; i < outline.size(); ++i)
    if (outline[i].height > outline[i - 1].height && std::max(outline[i].diameter, outline[i - 1].diameter) > 0)
      bodies.push_back({part, {section(outline[i - 1], outline[i], above)}});
}

/// Returns an end that widens from the diameter `blunt` to the tool's diameter, and a cylinder above this end.
ConvexBody pointed(const ToolGeometry& g, double blunt, double half_angle) {
  const double end = blunt / 2, radius = g.diameter / 2;
  const double tall = (radius - end) / std::tan(half_angle * rad_per_deg);
  if (tall >= g.flutes) return {ToolPart::cutting, {{Form::cone, 0, g.flutes, end, end + (radius - end) * g.flutes / tall}}};
  return {ToolPart::cutting, {{Form::cone, 0, tall, end, radius}, cylinder(tall, g.flutes, radius)}};
}

/// Returns the cutting part of a taper tool, which reaches the tool's diameter at the top of the flutes, where the shank begins. If the end
/// would have a negative diameter, the end is a point.
ConvexBody tapered(const ToolGeometry& g) {
  const double end = g.diameter - 2 * g.flutes * std::tan(g.angle * rad_per_deg);
  return pointed(g, std::max(end, 0.0), g.angle);
}

ConvexBody rounded(const ToolGeometry& g, Form form, double corner) {
  const double radius = g.diameter / 2;
  ConvexBody body{ToolPart::cutting, {{form, 0, corner, radius - corner, radius}}};
  if (g.flutes > corner) body.solids.push_back(cylinder(corner, g.flutes, radius));
  return body;
}

std::vector<ConvexBody> cutting_part(const ToolGeometry& g) {
  switch (g.kind) {
    case ToolKind::ball: return {rounded(g, Form::ball, g.diameter / 2)};
    case ToolKind::bull:
      if (g.corner >= g.diameter / 2) return {rounded(g, Form::ball, g.diameter / 2)};
      if (g.corner > 0) return {rounded(g, Form::torus, g.corner)};
      break;
    case ToolKind::drill:
    case ToolKind::chamfer: return {pointed(g, g.tip, g.angle / 2)};
    case ToolKind::taper: return {tapered(g)};
    case ToolKind::form: {
      std::vector<ConvexBody> bodies;
      add_outline(bodies, ToolPart::cutting, g.profile, 0);
      return bodies;
    }
    case ToolKind::flat:
    case ToolKind::tslot:
    case ToolKind::turning: break;
  }
  return {{ToolPart::cutting, {cylinder(0, g.flutes, g.diameter / 2)}}};
}

}  // namespace

ToolShape shape_of(const ToolGeometry& g) {
  if (g.kind == ToolKind::turning) return {g, {}, insert_bodies(g)};
  ToolShape shape{g, cutting_part(g), {}};
  if (!g.shank.empty()) add_outline(shape.bodies, ToolPart::shank, g.shank, 0);
  else if (g.length > g.flutes && g.kind != ToolKind::form)
    shape.bodies.push_back({ToolPart::beyond_flutes, {cylinder(g.flutes, g.length, g.diameter / 2)}});
  add_outline(shape.bodies, ToolPart::holder, g.holder, g.length);
  return shape;
}

ToolShape holder_of(const ToolShape& tool) {
  ToolShape shape = tool;
  std::erase_if(shape.insert, [](const InsertBody& body) { return body.part != ToolPart::holder; });
  return shape;
}

}  // namespace kadr
