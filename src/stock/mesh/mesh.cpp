// Computes volume, area and box of a mesh. Used by stock/mesh and stock/surface.

#include "stock/mesh/mesh.h"

#include <algorithm>

#include "base/matrix.h"

namespace kadr {

void VolumeSum::add(const Corners& triangle) {
  const Vec3 a = triangle[0] - middle_, b = triangle[1] - middle_, c = triangle[2] - middle_;
  six_ += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
}

double area_of(const Corners& triangle) { return length(cross(triangle[1] - triangle[0], triangle[2] - triangle[0])) / 2; }

double volume_of(const Mesh& mesh) {
  VolumeSum sum(mesh.points.empty() ? Vec3{} : mesh.point(0));
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) sum.add(mesh.corners(t));
  return sum.volume();
}

Box3 box_of(const Mesh& mesh) {
  if (mesh.points.empty()) return {};
  Box3 box{mesh.point(0), mesh.point(0)};
  for (std::size_t i = 1; i < mesh.point_count(); ++i)
    for (int d = 0; d < 3; ++d) {
      const double place = double(mesh.points[3 * i + std::size_t(d)]);
      along(box.least, d) = std::min(along(box.least, d), place);
      along(box.most, d) = std::max(along(box.most, d), place);
    }
  return box;
}

double area_of(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) sum += area_of(mesh.corners(t));
  return sum;
}

}  // namespace kadr
