#pragma once
// NearestTriangle: how far points are from the triangles of a mesh. A tree of boxes, each around its triangles, halved three times along
// its longest sides; eight boxes are held against a point at a time, below them those of four triangles, then four triangles.
//
// The answer is the least of the distances to all triangles, to the bit: boxes are left out only where they are farther by more than
// rounding. So neither the order of the questions nor the hint changes it.

#include <cstdint>
#include <vector>

#include "stock/mesh/mesh.h"
#include "stock/part/four_triangles.h"

namespace kadr {

class NearestTriangle {
 public:
  /// 45 bytes a triangle, 20 more while it is built; at least one triangle.
  explicit NearestTriangle(const Mesh& mesh, int threads = 1);

  /// mm. `hint`: where the search begins, any number that an earlier answer left there, or 0; points in a row that lie near each other
  /// are found faster by it.
  double distance(const Vec3& point, std::uint32_t& hint) const;

 private:
  static constexpr std::size_t width = 8;
  static constexpr std::uint32_t in_block = 4;
  /// Boxes, wider than their triangles by what single precision may lose; those that are none lie nowhere.
  struct Node {
    alignas(16) float least[3][width], most[3][width];
    std::uint32_t first_child;  // of nodes_, or `of_blocks` and one of blocks_; the others follow it
  };
  class Search;
  void put_blocks(const Mesh& mesh, const std::vector<std::uint32_t>& order, std::size_t node);
  void put_boxes(std::size_t node, std::size_t first_child, std::size_t last_child);

  float pad_ = 0;            // mm
  std::vector<Node> nodes_;  // level by level, from the lowest; the root is the last
  /// In the order of stock/part/near_groups; where there are fewer, the last one stands for the rest.
  std::vector<FourTriangles> blocks_;
};

}  // namespace kadr
