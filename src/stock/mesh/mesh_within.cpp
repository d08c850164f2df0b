// Computes the volume and area of a mesh inside a box: clips triangles by the planes of the box. Used by stock/blank and session/cutting.
//
// Method: consider a vertical line through the box. Each crossing of the line with the closed mesh, outside the box, is moved to the floor
// or ceiling of the box. The signed sum of the crossings is then the length of the line inside both the mesh and the box. So the
// contribution of each triangle is its height above the floor, integrated over the area of the triangle that is between the walls of the
// box.

#include "stock/mesh/mesh_within.h"

#include <algorithm>
#include <array>

#include "base/matrix.h"

namespace kadr {
namespace {

/// A convex polygon. A triangle gets at most one more corner from each of the six planes, so nine corners suffice.
struct Polygon {
  std::array<Vec3, 12> corner;
  std::size_t count = 0;

  void add(const Vec3& p) { corner[count++] = p; }
};

/// Returns the part of the polygon above a position along the axis (`side` 1), or below the position (`side` −1).
Polygon clipped(const Polygon& from, int axis, double place, int side) {
  Polygon to;
  for (std::size_t i = 0; i < from.count; ++i) {
    const Vec3 a = from.corner[i], b = from.corner[(i + 1) % from.count];
    const double above = side * (along(a, axis) - place), next = side * (along(b, axis) - place);
    if (above >= 0) to.add(a);
    if ((above < 0) == (next < 0) || above == 0 || next == 0) continue;
    Vec3 between = a + above / (above - next) * (b - a);
    along(between, axis) = place;
    to.add(between);
  }
  return to;
}

/// Visits the triangles of the polygon, which is divided like a fan from its first corner.
template <class Visit>
void each_triangle(const Polygon& p, const Visit& visit) {
  for (std::size_t i = 2; i < p.count; ++i) visit(p.corner[0], p.corner[i - 1], p.corner[i]);
}

/// Returns the area in mm² as seen from above; positive if the corners are in counter-clockwise order.
double flat_area(const Vec3& a, const Vec3& b, const Vec3& c) { return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2; }

void add_triangle(const Polygon& triangle, const Box3& box, MeshWithin& sum) {
  Polygon between_walls = triangle;
  for (int d = 0; d < 2; ++d) {
    between_walls = clipped(between_walls, d, along(box.least, d), 1);
    between_walls = clipped(between_walls, d, along(box.most, d), -1);
  }
  const double height = box.most.z - box.least.z;
  each_triangle(clipped(between_walls, 2, box.most.z, 1), [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    // A triangle in the plane of the ceiling is skipped here, because it is counted with the part below the ceiling.
    const bool at_ceiling = std::max({a.z, b.z, c.z}) <= box.most.z;
    if (!at_ceiling) sum.volume += flat_area(a, b, c) * height;
  });
  each_triangle(clipped(clipped(between_walls, 2, box.least.z, 1), 2, box.most.z, -1), [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    sum.volume += flat_area(a, b, c) * ((a.z + b.z + c.z) / 3 - box.least.z);
    sum.area += length(cross(b - a, c - a)) / 2;
  });
}

}  // namespace

MeshWithin mesh_within(const Mesh& mesh, const Box3& box) {
  MeshWithin sum;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    Polygon triangle;
    for (std::size_t k = 0; k < 3; ++k) triangle.add(mesh.corner(t, k));
    const auto all_beyond = [&](int axis, double place, int side) {
      return std::all_of(triangle.corner.begin(), triangle.corner.begin() + 3,
                         [&](const Vec3& p) { return side * (along(p, axis) - place) >= 0; });
    };
    bool outside = all_beyond(2, box.least.z, -1);
    for (int d = 0; d < 2 && !outside; ++d) outside = all_beyond(d, along(box.least, d), -1) || all_beyond(d, along(box.most, d), 1);
    if (!outside) add_triangle(triangle, box, sum);
  }
  return sum;
}

}  // namespace kadr
