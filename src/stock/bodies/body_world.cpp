// Adds solid bodies to the module, and computes distances with it. Used by stock/bodies/moving_bodies; tested by
// tests/stock/body_world_test.cpp.

#include "stock/bodies/body_world.h"

#include <array>
#include <cmath>

namespace kadr {
namespace {

// Greatest error in mm where straight lines replace the arcs of a rounded end; the body becomes larger, never smaller.
constexpr double chord_of_round = 0.002;

/// Returns the 3 × 4 matrix of a pose, row by row.
std::array<double, 12> rows_of(const LinkPose& p) {
  const auto& [x, y, z] = p.turn.rows;
  return {x.x, x.y, x.z, p.at.x, y.x, y.y, y.z, p.at.y, z.x, z.y, z.z, p.at.z};
}

BodyBall ball_of(const Box3& box) { return {0.5 * (box.least + box.most), 0.5 * length(box.most - box.least)}; }

std::optional<SolidBody> body_at(int number, Vec3 middle, const Box3& box, bool convex = true) {
  if (number < 0) return std::nullopt;
  return SolidBody{number, {{}, middle}, ball_of(box), convex};
}

}  // namespace

BodyWorld::BodyWorld(const KadrBodiesInterface& door) : door_(&door), bodies_(door.make(), door.drop) {}

std::optional<SolidBody> BodyWorld::add(const BodyShape& shape) {
  if (!bodies_ || shape.form == BodyShape::Form::file) return std::nullopt;
  if (shape.form == BodyShape::Form::box) {
    const Vec3 size = shape.most - shape.least;
    return body_at(door_->add_box(bodies_.get(), size.x, size.y, size.z), 0.5 * (shape.least + shape.most), {shape.least, shape.most});
  }
  const double radius = shape.diameter / 2;
  const auto [x, y] = shape.centre;
  return body_at(door_->add_cylinder(bodies_.get(), shape.diameter, shape.top - shape.bottom), {x, y, 0.5 * (shape.bottom + shape.top)},
                 {{x - radius, y - radius, shape.bottom}, {x + radius, y + radius, shape.top}});
}

std::optional<SolidBody> BodyWorld::add(const Mesh& mesh) {
  if (!bodies_) return std::nullopt;
  const int number = door_->add_mesh(bodies_.get(), mesh.points.data(), mesh.point_count(), mesh.triangles.data(), mesh.triangle_count());
  return body_at(number, {}, box_of(mesh), false);
}

std::optional<SolidBody> BodyWorld::add(const ConvexBody& body) {
  if (!bodies_) return std::nullopt;
  const std::vector<Vec2> circles = circles_of(body, chord_of_round);
  const Vec2 first = circles.front(), last = circles.back();
  const double widest = body.widest();
  const Box3 box{{-widest, -widest, first.y}, {widest, widest, last.y}};
  if (circles.size() == 2 && first.x == last.x)
    return body_at(door_->add_cylinder(bodies_.get(), 2 * first.x, last.y - first.y), {0, 0, 0.5 * (first.y + last.y)}, box);
  std::vector<double> numbers;
  for (const Vec2& c : circles) numbers.insert(numbers.end(), {c.x, c.y});
  auto added = body_at(door_->add_round(bodies_.get(), numbers.data(), int(circles.size())), {}, box);
  // The module replaces each circle by a polygon that encloses the circle, so the body becomes slightly larger.
  if (added) added->ball.radius *= 1.001;
  return added;
}

BodyGap BodyWorld::gap(const SolidBody& a, const LinkPose& pose_a, const SolidBody& b, const LinkPose& pose_b) const {
  const auto rows_a = rows_of(pose_a.after(a.pose)), rows_b = rows_of(pose_b.after(b.pose));
  double nearest[6] = {};
  const double distance = door_->distance(bodies_.get(), a.number, rows_a.data(), b.number, rows_b.data(), nearest);
  return {std::isnan(distance) ? 0 : distance, {nearest[0], nearest[1], nearest[2]}, {nearest[3], nearest[4], nearest[5]}};
}

double BodyWorld::depth(const SolidBody& a, const LinkPose& pose_a, const SolidBody& b, const LinkPose& pose_b) const {
  const auto rows_a = rows_of(pose_a.after(a.pose)), rows_b = rows_of(pose_b.after(b.pose));
  return door_->depth(bodies_.get(), a.number, rows_a.data(), b.number, rows_b.data());
}

}  // namespace kadr
