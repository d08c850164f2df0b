// kadr-bodies.so: computes the distance between solid bodies with the library FCL. stock/bodies/bodies_library loads this module when it is
// needed, since loading FCL and the libraries that FCL needs would slow down every command.

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <vector>

#include "stock/bodies/bodies_interface.h"

struct KadrBodies {
  std::vector<std::shared_ptr<fcl::CollisionGeometryd>> all;
};

namespace {

using Mesh = fcl::BVHModel<fcl::OBBRSSd>;

constexpr int sides = 128;          // sides of the polygon around a circle, which is at most 0.03 % of the radius too large
constexpr double tolerance = 1e-9;  // mm between two steps at which the search ends: the result is then within 5e-6 of the distance
constexpr double doubtful = 1e-4;   // mm: a result that exceeds the proven distance by more is not trusted

fcl::Transform3d placed(const double* pose) {
  fcl::Transform3d t = fcl::Transform3d::Identity();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) t(row, column) = pose[4 * row + column];
  return t;
}

/// Calls `make` and catches all exceptions, which must not leave the module.
template <class Make>
int added(KadrBodies* bodies, const Make& make) {
  try {
    bodies->all.push_back(make());
    return int(bodies->all.size()) - 1;
  } catch (const std::exception&) {
    return -1;
  }
}

int add_box(KadrBodies* bodies, double x, double y, double z) {
  return added(bodies, [&] { return std::make_shared<fcl::Boxd>(x, y, z); });
}

int add_cylinder(KadrBodies* bodies, double diameter, double height) {
  return added(bodies, [&] { return std::make_shared<fcl::Cylinderd>(diameter / 2, height); });
}

/// Builds a solid of revolution from circles around its axis: polygons replace the circles, and faces connect the polygons.
std::shared_ptr<fcl::CollisionGeometryd> round_body(const double* circles, int count) {
  const double about = 1 / std::cos(fcl::constantsd::pi() / sides);
  const auto points = std::make_shared<std::vector<fcl::Vector3d>>();
  const auto faces = std::make_shared<std::vector<int>>();
  int face_count = 0, below = 0, below_size = 0;
  const auto face = [&](std::vector<int> corners) {
    faces->push_back(int(corners.size()));
    faces->insert(faces->end(), corners.begin(), corners.end());
    ++face_count;
  };
  const auto end_face = [&](int first, bool upwards) {
    std::vector<int> corners;
    for (int i = 0; i < sides; ++i) corners.push_back(first + (upwards ? i : sides - 1 - i));
    face(corners);
  };
  for (int c = 0; c < count; ++c) {
    const double radius = circles[2 * c] * about, height = circles[2 * c + 1];
    const int first = int(points->size()), size = circles[2 * c] > 0 ? sides : 1;
    for (int i = 0; i < size; ++i) {
      const double angle = 2 * fcl::constantsd::pi() * i / sides;
      points->emplace_back(size == 1 ? 0 : radius * std::cos(angle), size == 1 ? 0 : radius * std::sin(angle), height);
    }
    if (c == 0 && size > 1) end_face(first, false);
    for (int i = 0; c > 0 && i < sides; ++i) {
      const int next = (i + 1) % sides;
      if (below_size == 1) face({below, first + next, first + i});
      else if (size == 1) face({below + i, below + next, first});
      else face({below + i, below + next, first + next, first + i});
    }
    if (c == count - 1 && size > 1) end_face(first, true);
    below = first;
    below_size = size;
  }
  return std::make_shared<fcl::Convexd>(points, face_count, faces, true);
}

int add_round(KadrBodies* bodies, const double* circles, int count) {
  return added(bodies, [&] { return round_body(circles, count); });
}

int add_mesh(KadrBodies* bodies, const float* points, std::size_t point_count, const std::uint32_t* triangles, std::size_t triangle_count) {
  return added(bodies, [&] {
    const auto mesh = std::make_shared<Mesh>();
    std::vector<fcl::Vector3d> places(point_count);
    for (std::size_t i = 0; i < point_count; ++i) places[i] = {points[3 * i], points[3 * i + 1], points[3 * i + 2]};
    std::vector<fcl::Triangle> corners(triangle_count);
    for (std::size_t i = 0; i < triangle_count; ++i) corners[i].set(triangles[3 * i], triangles[3 * i + 1], triangles[3 * i + 2]);
    if (mesh->beginModel(int(triangle_count), int(point_count)) != fcl::BVH_OK || mesh->addSubModel(places, corners) != fcl::BVH_OK ||
        mesh->endModel() != fcl::BVH_OK)
      throw std::bad_alloc();
    return mesh;
  });
}

const fcl::CollisionGeometryd* body(const KadrBodies* bodies, int number) { return bodies->all[std::size_t(number)].get(); }

/// Returns how far a convex body extends from the origin of its own coordinates along the direction `along`.
double reach(const fcl::CollisionGeometryd& shape, const fcl::Vector3d& along) {
  if (const auto* const box = dynamic_cast<const fcl::Boxd*>(&shape)) return 0.5 * box->side.dot(along.cwiseAbs());
  if (const auto* const cylinder = dynamic_cast<const fcl::Cylinderd*>(&shape))
    return cylinder->radius * std::hypot(along[0], along[1]) + 0.5 * cylinder->lz * std::fabs(along[2]);
  double most = -std::numeric_limits<double>::infinity();
  for (const fcl::Vector3d& point : dynamic_cast<const fcl::Convexd&>(shape).getVertices()) most = std::max(most, point.dot(along));
  return most;
}

bool is_mesh(const fcl::CollisionGeometryd& shape) { return shape.getObjectType() == fcl::OT_BVH; }

struct Found {
  double distance = std::numeric_limits<double>::quiet_NaN();
  double certain = -std::numeric_limits<double>::infinity();  // proven distance, mm: of two planes across the line of nearest points
  fcl::Vector3d on_first{0, 0, 0}, on_second{0, 0, 0};
};

Found found_by(fcl::GJKSolverType solver, const fcl::CollisionGeometryd& a, const fcl::Transform3d& at_a, const fcl::CollisionGeometryd& b,
               const fcl::Transform3d& at_b) {
  Found found;
  try {
    fcl::DistanceRequestd request(true, false);
    request.gjk_solver_type = solver;
    request.distance_tolerance = tolerance;
    fcl::DistanceResultd result;
    found.distance = fcl::distance(&a, at_a, &b, at_b, request, result);
    found.on_first = result.nearest_points[0];
    found.on_second = result.nearest_points[1];
  } catch (const std::exception&) {
    return found;
  }
  if (!(found.distance > 0) || is_mesh(a) || is_mesh(b)) {
    found.certain = found.distance;
    return found;
  }
  const fcl::Vector3d direction = (found.on_second - found.on_first).normalized();
  found.certain = direction.dot(at_b.translation() - at_a.translation()) - reach(a, at_a.linear().transpose() * direction) -
                  reach(b, at_b.linear().transpose() * -direction);
  return found;
}

/// Computes the distance with FCL's own search. If two parallel planes between the bodies do not prove that distance (Found::certain),
/// libccd's search runs too, which is far off for 1 in 100 pairs of boxes with parallel sides. The result with the greater proven distance
/// is used.
double distance(KadrBodies* bodies, int a, const double* pose_a, int b, const double* pose_b, double* nearest) {
  const fcl::CollisionGeometryd &first = *body(bodies, a), &second = *body(bodies, b);
  const fcl::Transform3d at_a = placed(pose_a), at_b = placed(pose_b);
  Found found = found_by(fcl::GST_INDEP, first, at_a, second, at_b);
  if (!(found.certain > found.distance - doubtful)) {
    const Found other = found_by(fcl::GST_LIBCCD, first, at_a, second, at_b);
    if (other.certain > found.certain) found = other;
    if (!std::isnan(found.distance)) found.distance = std::max(found.certain, found.distance < 0 ? found.distance : 0);
  }
  for (int i = 0; i < 3; ++i) nearest[i] = found.on_first[i], nearest[3 + i] = found.on_second[i];
  return found.distance;
}

/// Computes how deep two bodies overlap, with FCL's own search: libccd's result is off by hundredths of a mm on cylinders.
double depth(KadrBodies* bodies, int a, const double* pose_a, int b, const double* pose_b) {
  if (is_mesh(*body(bodies, a)) || is_mesh(*body(bodies, b))) return 0;
  try {
    fcl::CollisionRequestd request(1, true);
    request.gjk_solver_type = fcl::GST_INDEP;
    fcl::CollisionResultd result;
    fcl::collide(body(bodies, a), placed(pose_a), body(bodies, b), placed(pose_b), request, result);
    double deepest = 0;
    for (std::size_t i = 0; i < result.numContacts(); ++i) deepest = std::max(deepest, std::fabs(result.getContact(i).penetration_depth));
    return deepest;
  } catch (const std::exception&) {
    return 0;
  }
}

constexpr KadrBodiesInterface door = {kadr_bodies_version,
                                      [] { return new (std::nothrow) KadrBodies; },
                                      [](KadrBodies* bodies) { delete bodies; },
                                      add_box,
                                      add_cylinder,
                                      add_round,
                                      add_mesh,
                                      distance,
                                      depth};

}  // namespace

extern "C" __attribute__((visibility("default"))) const KadrBodiesInterface* kadr_bodies_door() { return &door; }
