// Builds the outlines of turning tools from the angles and sizes of their inserts (docs/commands/cut.md).

#include "stock/tool/insert_body.h"

#include <cmath>

#include "base/vec.h"
#include "config/tools/convex_parts.h"
#include "stock/tool/round_solid.h"

namespace kadr {
namespace {

InsertPoint operator+(const InsertPoint& a, const InsertPoint& b) { return {a.x + b.x, a.z + b.z}; }
InsertPoint operator*(double k, const InsertPoint& p) { return {k * p.x, k * p.z}; }

/// Returns the outward normal of a straight edge with this direction; the inside of the outline is on the left of the edge.
InsertPoint right_of(const InsertPoint& direction) { return {direction.z, -direction.x}; }

/// Returns an outline with straight edges in the given directions; the directions may have any length. One edge follows each corner.
InsertBody body_of(ToolPart part, std::vector<InsertCorner> corners, const std::vector<InsertPoint>& directions) {
  InsertBody body{part, std::move(corners), {}};
  for (const InsertPoint& d : directions) body.outward.push_back(right_of(d));
  return body;
}

InsertBody polygon(ToolPart part, const InsertOutline& outline) {
  InsertBody body{part, {}, {}};
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const InsertPoint delta = outline[(i + 1) % outline.size()] + -1.0 * outline[i];
    body.corners.push_back({outline[i], 0});
    body.outward.push_back((1 / std::sqrt(delta.x * delta.x + delta.z * delta.z)) * right_of(delta));
  }
  return body;
}

InsertPoint nose_centre(const ToolGeometry& g) { return {-g.insert.tip_x * g.corner, -g.insert.tip_z * g.corner}; }

InsertBody round_insert(const ToolGeometry& g) {
  const InsertCorner disc{nose_centre(g), g.corner};
  const double half = 0.5, root = std::sqrt(3.0) / 2;
  return body_of(ToolPart::cutting, {disc, disc, disc}, {{-1, 0}, {half, -root}, {half, root}});
}

/// Returns the direction of a cutting edge of an insert. `from_feed` is the angle, in degrees, between the edge and the direction along z
/// in which the tip points. At a positive angle the edge points away from the direction along x in which the tip points.
InsertPoint edge_direction(const InsertGeometry& i, double from_feed) {
  const SinCos turn = sincos_deg(from_feed);
  return {i.tip_x > 0 ? -turn.sin : turn.sin, i.tip_z > 0 ? turn.cos : -turn.cos};
}

/// Returns a parallelogram with a rounded nose. The two cutting edges have the same length, measured from the sharp corner.
InsertBody angular_insert(const ToolGeometry& g, ToolPart part, double edge) {
  const double lead = g.insert.lead.value_or(0);
  InsertPoint first = edge_direction(g.insert, lead), second = edge_direction(g.insert, lead + g.angle);
  if (first.x * second.z - first.z * second.x < 0) std::swap(first, second);
  const InsertPoint centre = nose_centre(g), middle = edge_direction(g.insert, lead + g.angle / 2);
  const InsertPoint sharp = centre + (-g.corner / sincos_deg(g.angle / 2).sin) * middle;
  const InsertPoint a = sharp + edge * first, b = sharp + edge * second;
  return body_of(part, {{centre, g.corner}, {a, 0}, {a + edge * second, 0}, {b, 0}}, {first, second, -1.0 * first, -1.0 * second});
}

/// Returns a blade of the length `deep` in mm, whose cutting edge has two rounded corners.
InsertBody grooving_insert(const ToolGeometry& g, ToolPart part, double deep) {
  const InsertGeometry& i = g.insert;
  const bool radial = i.lead != 0;
  const int towards = radial ? i.tip_x : i.tip_z, sideways = radial ? i.tip_z : i.tip_x;
  const double back = towards > 0 ? -1 : 1;  // direction from the cutting edge into the blade
  const InsertPoint up = radial ? InsertPoint{back, 0} : InsertPoint{0, back};
  InsertPoint across = radial ? InsertPoint{0, 1} : InsertPoint{1, 0};
  // Middle of the cutting edge, relative to the programmed point.
  const InsertPoint edge = (-sideways * i.width / 2) * across + (towards == 0 ? -g.corner : 0) * up;
  if (across.x * up.z - across.z * up.x < 0) across = -1.0 * across;
  const double half = i.width / 2, inner = half - g.corner;
  return body_of(part,
                 {{edge + g.corner * up + -inner * across, g.corner},
                  {edge + g.corner * up + inner * across, g.corner},
                  {edge + deep * up + half * across, 0},
                  {edge + deep * up + -half * across, 0}},
                 {across, up, -1.0 * across, -1.0 * up});
}

}  // namespace

std::vector<InsertBody> insert_bodies(const ToolGeometry& g) {
  std::vector<InsertBody> bodies;
  const auto add = [&](ToolPart part, double size) {
    bodies.push_back(g.insert.width > 0 ? grooving_insert(g, part, size) : angular_insert(g, part, size));
  };
  if (!g.insert.profile.empty()) {
    for (const InsertOutline& outline : convex_parts(g.insert.profile)) bodies.push_back(polygon(ToolPart::cutting, outline));
  } else if (g.insert.width == 0 && g.angle == 0) {
    bodies.push_back(round_insert(g));
  } else {
    add(ToolPart::cutting, g.flutes);
    if (g.length > g.flutes) add(ToolPart::beyond_flutes, g.length);
  }
  for (const InsertOutline& outline : convex_parts(g.insert.holder)) bodies.push_back(polygon(ToolPart::holder, outline));
  return bodies;
}

}  // namespace kadr
