#pragma once
// NearestTriangle: the distance of points from the triangles of a mesh. It searches a tree of boxes: eight boxes of a node are
// compared with the point at a time, below them the boxes of four triangles, then four triangles. A node is its triangles halved
// three times along the longest sides.
//
// The result is the least of the distances to all triangles, to the bit: a box is skipped only if it is farther by more than
// rounding. So neither the order of the queries nor the hint changes a result.

#include <cstdint>
#include <vector>

#include "stock/mesh/mesh.h"
#include "stock/part/four_triangles.h"

namespace kadr {

class NearestTriangle {
 public:
  /// Takes 45 bytes per triangle, and 20 more during construction; needs at least one triangle.
  explicit NearestTriangle(const Mesh& mesh, int threads = 1);

  /// Returns the distance in mm. `hint` is where the search begins: 0, or a number that an earlier query left there. It makes queries
  /// for consecutive points that are near each other faster.
  double distance(const Vec3& point, std::uint32_t& hint) const;

 private:
  static constexpr std::size_t width = 8;
  static constexpr std::uint32_t in_block = 4;
  /// Boxes, enlarged by what single precision may lose. Unused boxes are placed at `nowhere`.
  struct Node {
    alignas(16) float least[3][width], most[3][width];
    std::uint32_t first_child;  // number in nodes_, or in blocks_ with the bit `of_blocks`; the other children follow it
  };
  class Search;
  void put_blocks(const Mesh& mesh, const std::vector<std::uint32_t>& order, std::size_t node);
  void put_boxes(std::size_t node, std::size_t first_child, std::size_t last_child);

  float pad_ = 0;            // mm
  std::vector<Node> nodes_;  // level by level, the lowest first; the root is the last
  /// In the order of stock/part/near_groups; the last triangle fills up an incomplete block.
  std::vector<FourTriangles> blocks_;
};

}  // namespace kadr
