#pragma once
// TriangleAcross: intersects one triangle of a mesh with lines along one axis. Used by stock/mesh/mesh_index and stock/part.
//
// TriangleAcross intersects the edges of the triangle with a ray in the plane across the lines. The position of an intersection depends
// only on the two ends of the edge, so two triangles with a common edge get exactly the same position.

#include <algorithm>
#include <array>

#include "stock/mesh/mesh.h"

namespace kadr {

struct MeshHit {
  double place;  // position of the intersection along the axis, mm
  int turn;      // 1 if the line enters the solid, -1 if the line leaves the solid
  std::uint32_t triangle;
};

/// The intersection of a triangle with the plane at one position `v`: a segment from one edge of the triangle to another edge.
struct TriangleRow {
  struct EdgePlace {
    double u, w;
  };
  EdgePlace left, right;
  int turn;

  bool holds(double u) const { return left.u <= u && u < right.u; }
  /// Returns the coordinate w of the segment at the coordinate `u`.
  ///   pre  holds(u)
  double place(double u) const { return left.w + (u - left.u) / (right.u - left.u) * (right.w - left.w); }
};

/// A triangle in the coordinates u, v, w along the axes (family + 1) % 3, (family + 2) % 3 and family.
class TriangleAcross {
 public:
  TriangleAcross(const Mesh& mesh, std::size_t triangle, int family) {
    const std::size_t u = std::size_t(family + 1) % 3, v = std::size_t(family + 2) % 3, w = std::size_t(family);
    for (std::size_t k = 0; k < 3; ++k) {
      const float* const p = &mesh.points[3 * std::size_t(mesh.triangles[3 * triangle + k])];
      corner_[k] = {double(p[u]), double(p[v]), double(p[w])};
    }
  }

  double least_u() const { return std::min({corner_[0].u, corner_[1].u, corner_[2].u}); }
  double most_u() const { return std::max({corner_[0].u, corner_[1].u, corner_[2].u}); }
  double least_v() const { return std::min({corner_[0].v, corner_[1].v, corner_[2].v}); }
  double most_v() const { return std::max({corner_[0].v, corner_[1].v, corner_[2].v}); }

  /// Computes the intersection with the plane at `v`. Returns false if no edge crosses `v`. Otherwise two edges cross it, one upwards and
  /// one downwards.
  bool row(double v, TriangleRow& row) const {
    TriangleRow::EdgePlace place[2];
    bool upwards[2];
    int found = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner &a = corner_[k], &b = corner_[(k + 1) % 3];
      const bool up = a.v <= v;
      if (up == (b.v <= v)) continue;
      place[found] = up ? edge_place(a, b, v) : edge_place(b, a, v);
      upwards[found++] = up;
    }
    if (found != 2) return false;
    const bool first_is_right = place[1].u < place[0].u;
    row = {place[first_is_right], place[!first_is_right], upwards[!first_is_right] ? -1 : 1};
    return true;
  }
  /// Returns the least and the greatest u of the part of the triangle between two positions of v.
  std::array<double, 2> between(double low, double high) const {
    std::array<double, 2> extent{most_u(), least_u()};
    const auto include = [&](double u) { extent = {std::min(extent[0], u), std::max(extent[1], u)}; };
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner &a = corner_[k], &b = corner_[(k + 1) % 3];
      if (a.v >= low && a.v <= high) include(a.u);
      for (const double v : {low, high})
        if ((a.v < v) != (b.v < v)) include(edge_place(a, b, v).u);
    }
    return extent;
  }

 private:
  struct Corner {
    double u, v, w;
  };
  /// Computes the point of an edge at `v`. The computation starts at the lower end of the edge, whatever the orientation of the triangle,
  /// so that both triangles of an edge get exactly the same numbers.
  static TriangleRow::EdgePlace edge_place(const Corner& low, const Corner& high, double v) {
    const double share = (v - low.v) / (high.v - low.v);
    const auto between = [&](double a, double b) { return std::clamp(a + share * (b - a), std::min(a, b), std::max(a, b)); };
    return {between(low.u, high.u), between(low.w, high.w)};
  }

  std::array<Corner, 3> corner_;
};

}  // namespace kadr
