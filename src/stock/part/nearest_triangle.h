#pragma once
// NearestTriangle: computes the distance of points from the triangles of a mesh, by searching a tree of boxes. At each node, the point is
// compared with the boxes of eight child nodes at once; at the lowest level, with the boxes of eight blocks of four triangles, then with
// the four triangles of a block. To divide the triangles of a node into eight, they are halved three times along the longest side.
//
// The result is the least of the distances to all triangles, bit for bit: a box is skipped only if it is farther away by more than rounding
// errors. So neither the order of the queries nor the hint changes a result.

#include <cstdint>
#include <vector>

#include "stock/mesh/mesh.h"
#include "stock/part/four_triangles.h"

namespace kadr {

class NearestTriangle {
 public:
  /// Builds the tree. The tree needs 45 bytes per triangle, and 20 bytes more during construction. The mesh must have at least one
  /// triangle.
  explicit NearestTriangle(const Mesh& mesh, int threads = 1);

  /// Returns the distance in mm. The search starts at `hint`: the caller passes 0, or the value that an earlier query stored in `hint`,
  /// which makes queries for points close to each other faster.
  double distance(const Vec3& point, std::uint32_t& hint) const;

 private:
  static constexpr std::size_t width = 8;
  static constexpr std::uint32_t in_block = 4;
  /// The boxes of eight children, enlarged by the possible rounding error of single precision. Unused boxes are at the position `nowhere`,
  /// so no point is close to them.
  struct Node {
    alignas(16) float least[3][width], most[3][width];
    // Index of the first child in nodes_, or in blocks_ if the bit `of_blocks` is set; the other children follow.
    std::uint32_t first_child;
  };
  class Search;
  void put_blocks(const Mesh& mesh, const std::vector<std::uint32_t>& order, std::size_t node);
  void put_boxes(std::size_t node, std::size_t first_child, std::size_t last_child);

  float pad_ = 0;            // enlargement of the boxes in mm, because of rounding errors
  std::vector<Node> nodes_;  // nodes sorted by level, the lowest level first; the root is the last node
  /// Blocks in the order of stock/part/near_groups; an incomplete last block is filled with copies of the last triangle.
  std::vector<FourTriangles> blocks_;
};

}  // namespace kadr
