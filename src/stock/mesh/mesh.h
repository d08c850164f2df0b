#pragma once
// Mesh: triangles between numbered points.

#include <cstdint>
#include <vector>

#include "stock/brick/lattice.h"

namespace kadr {

/// Seen from outside the corners of a triangle go round counter-clockwise. Lengths mm.
struct Mesh {
  std::vector<float> points;             // x, y, z of each
  std::vector<std::uint32_t> triangles;  // three points each

  std::size_t point_count() const { return points.size() / 3; }
  std::size_t triangle_count() const { return triangles.size() / 3; }
  Vec3 point(std::size_t i) const { return {double(points[3 * i]), double(points[3 * i + 1]), double(points[3 * i + 2])}; }
  Vec3 corner(std::size_t triangle, std::size_t i) const { return point(triangles[3 * triangle + i]); }
};

/// mm³ inside it; below 0 if it is inside out.
double volume_of(const Mesh& mesh);

/// mm² of all triangles.
double area_of(const Mesh& mesh);

/// Around all points; of no points, one place.
Box3 box_of(const Mesh& mesh);

}  // namespace kadr
