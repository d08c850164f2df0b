#pragma once
// MeshIndex: finds the points (hits) at which lines along one axis meet the triangles of a mesh.
//
// Two triangles with a common edge compute the same position for it, bit for bit (stock/mesh/triangle_across). So a line enters a closed
// mesh as often as it leaves the mesh, even where the line meets an edge or a corner of a triangle.
//
//   law  on every line, the values `turn` of the hits of a closed mesh add up to 0   (tests/stock/mesh_blank_test)

#include <cstdint>
#include <vector>

#include "stock/mesh/triangle_across.h"

namespace kadr {

class MeshIndex {
 public:
  /// Builds the index for lines along the axis `family`. The object stores a reference to the mesh, and at most 28 bytes per triangle.
  MeshIndex(const Mesh& mesh, int family);
  /// Appends the hits of a line in no particular order. u, v: positions of the line along the axes (family + 1) % 3 and (family + 2) % 3.
  void hits(double u, double v, std::vector<MeshHit>& hits) const;

 private:
  struct Extent {
    std::uint32_t first, last;
  };
  std::uint32_t column(double u) const { return at(u, least_u_, per_u_, columns_); }
  std::uint32_t row(double v) const { return at(v, least_v_, per_v_, rows_); }
  static std::uint32_t at(double place, double least, double per, std::uint32_t count);
  void set_grid(const Box3& box, double squares);
  template <class Visit>
  void each_square(std::size_t triangle, const Visit& visit) const;
  std::size_t entries() const;
  void fill();

  const Mesh* mesh_;
  int family_;
  double least_u_ = 0, least_v_ = 0, per_u_ = 0, per_v_ = 0;
  std::uint32_t columns_ = 1, rows_ = 1;
  // Index in triangles_ of the first triangle of each square; the last element is the number of all entries.
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> triangles_;  // numbers of the triangles whose bounding rectangles overlap each square, square by square
};

}  // namespace kadr
