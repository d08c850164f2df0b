#pragma once
// NearestTriangle: how far points are from the triangles of a mesh. A tree of boxes, each around its triangles, quartered along its longest
// sides; four boxes are held against a point at a time.
//
// The answer is the least of the distances to all triangles, to the bit: boxes are left out only where they are farther by more than
// rounding. So neither the order of the questions nor the hint changes it.

#include <cstdint>
#include <vector>

#include "stock/mesh/mesh.h"

namespace kadr {

class NearestTriangle {
 public:
  /// 90 bytes a triangle, 16 more while it is built; at least one triangle.
  explicit NearestTriangle(const Mesh& mesh);

  /// mm. `hint`: where the search begins, any number that an earlier answer left there, or 0; points in a row that lie near each other
  /// are found faster by it.
  double distance(const Vec3& point, std::uint32_t& hint) const;

 private:
  static constexpr int width = 4;
  /// A box wider than its triangles by what single precision may lose.
  struct Node {
    alignas(16) float least[3][width], most[3][width];
    std::uint32_t child[width];  // of nodes_, or `of_triangles` and one of triangles_
  };
  struct Triangle {
    float corner[3][3];
  };
  struct Placed {
    float middle[3];  // three times
    std::uint32_t triangle;
  };
  std::uint32_t build(const Mesh& mesh, Placed* first, Placed* last);
  std::uint32_t put_triangle(const Mesh& mesh, std::uint32_t number, Node& node, int child);
  static double square_to(const Triangle& triangle, const Vec3& point);

  float pad_;  // mm
  std::vector<Node> nodes_;
  std::vector<Triangle> triangles_;  // in the order of the tree
};

}  // namespace kadr
