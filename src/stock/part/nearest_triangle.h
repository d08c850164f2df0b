#pragma once
// NearestTriangle: how far points are from the triangles of a mesh. A tree of boxes, each around its triangles, halved along its longest
// side.
//
// The answer is the least of the distances to all triangles, to the bit: boxes are left out only where they are farther by more than
// rounding. So neither the order of the questions nor the hint changes it.

#include <cstdint>
#include <vector>

#include "stock/mesh/mesh.h"

namespace kadr {

class NearestTriangle {
 public:
  /// 70 bytes a triangle; at least one.
  explicit NearestTriangle(const Mesh& mesh);

  /// mm. `hint`: where the search begins, any number that an earlier answer left there, or 0; points in a row that lie near each other
  /// are found faster by it.
  double distance(const Vec3& point, std::uint32_t& hint) const;

 private:
  struct Node {
    float least[3], most[3];
    std::uint32_t first;  // of the triangles; of a node that has others below: the second of these, the first follows it
    std::uint32_t count;  // 0: others below
  };
  struct Triangle {
    float corner[3][3];
  };
  void build(const Mesh& mesh, std::uint32_t* first, std::uint32_t* last);
  void put_leaf(const Mesh& mesh, Node& node, const std::uint32_t* first, const std::uint32_t* last);
  static double square_to(const Node& node, const Vec3& point);
  static double square_to(const Triangle& triangle, const Vec3& point);

  std::vector<Node> nodes_;
  std::vector<Triangle> triangles_;  // in the order of the leaves
};

}  // namespace kadr
