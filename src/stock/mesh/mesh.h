#pragma once
// Mesh: triangles whose corners are numbered points.

#include <cstdint>
#include <vector>

#include "stock/brick/lattice.h"

namespace kadr {

/// A surface of triangles, in mm. Seen from outside the body, the corners of a triangle are in counter-clockwise order.
struct Mesh {
  std::vector<float> points;             // coordinates x, y, z of each point, mm
  std::vector<std::uint32_t> triangles;  // numbers of the three corner points of each triangle

  std::size_t point_count() const { return points.size() / 3; }
  std::size_t triangle_count() const { return triangles.size() / 3; }
  Vec3 point(std::size_t i) const { return {double(points[3 * i]), double(points[3 * i + 1]), double(points[3 * i + 2])}; }
  Vec3 corner(std::size_t triangle, std::size_t i) const { return point(triangles[3 * triangle + i]); }
};

/// Returns the enclosed volume in mm³; negative if the triangles face inwards.
double volume_of(const Mesh& mesh);

/// Returns the area of all triangles in mm².
double area_of(const Mesh& mesh);

/// Returns the box around all points; an empty box at the origin if the mesh has no points.
Box3 box_of(const Mesh& mesh);

}  // namespace kadr
