// Computes volume, area and box of a mesh. Used by stock/mesh and stock/surface.

#include "stock/mesh/mesh.h"

#include <algorithm>

#include "base/matrix.h"

namespace kadr {
double volume_of(const Mesh& mesh) {
  // Reference point of the mesh itself: with the origin, which may be far away, more digits would be lost.
  const Vec3 middle = mesh.points.empty() ? Vec3{} : mesh.point(0);
  double six = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const Vec3 a = mesh.corner(t, 0) - middle, b = mesh.corner(t, 1) - middle, c = mesh.corner(t, 2) - middle;
    six += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
  }
  return six / 6;
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
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
    sum += length(cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0))) / 2;
  return sum;
}

}  // namespace kadr
