#pragma once
// Mesh: triangles whose corners are numbered points.

#include <array>
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
  std::array<Vec3, 3> corners(std::size_t triangle) const { return {corner(triangle, 0), corner(triangle, 1), corner(triangle, 2)}; }
};

/// A triangle by its corners.
using Corners = std::array<Vec3, 3>;

/// Adds up the volume that a mesh encloses, triangle by triangle.
class VolumeSum {
 public:
  /// `middle` is a point of the mesh: with the origin, which may be far away, more digits would be lost.
  explicit VolumeSum(const Vec3& middle) : middle_(middle) {}
  void add(const Corners& triangle);
  double volume() const { return six_ / 6; }

 private:
  Vec3 middle_;
  double six_ = 0;  // six times the volume
};

double area_of(const Corners& triangle);

/// Returns the enclosed volume in mm³; negative if the triangles face inwards.
double volume_of(const Mesh& mesh);

/// Returns the area of all triangles in mm².
double area_of(const Mesh& mesh);

/// Returns the box around all points; an empty box at the origin if the mesh has no points.
Box3 box_of(const Mesh& mesh);

}  // namespace kadr
