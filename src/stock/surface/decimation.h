#pragma once
// Decimation: simplifies a closed surface by removing its points one by one, as long as no removed point is farther than permitted from
// the simplified surface. Used by stock/surface/simplified_surface.
//
//          ring                    To remove point u, it is merged into its neighbour v: in the triangles around u, v replaces
//        ·──────·                  u, and the two triangles that contain both vanish. Each removed point is assigned to the
//       ╱ ╲    ╱ ╲                 triangle nearest to it. Before u is removed, u and all points assigned to its triangles are
//      ·── u ─▶ v ──·              checked against the new triangles. So the distance of every point of the exact surface from
//       ╲ ╱    ╲ ╱                 the simplified surface is always known (Kobbelt, Campagna and Seidel, A General Framework
//        ·──────·                  for Mesh Decimation, 1998).

#include <cstdint>
#include <vector>

#include "base/stop_token.h"
#include "stock/mesh/mesh.h"

namespace kadr {

class Decimation {
 public:
  /// Simplifies a closed mesh whose edges are each used by two triangles. Stores a reference to the mesh.
  explicit Decimation(const Mesh& exact);

  /// Removes points until each further removal would put some point farther than `most_off` mm from the simplified surface, or until the
  /// caller requests a stop.
  void go(double most_off, const StopToken& stop);
  Mesh mesh() const;

 private:
  struct Around {
    std::uint32_t triangle;
    Vec3 normal;  // unit normal; {} if the triangle has no area
  };
  struct Held {
    std::uint32_t point;
    std::size_t by;  // index in fresh_ (the triangles that a merge creates) of the triangle nearest to the point
  };
  struct Fresh {
    std::uint32_t triangle;
    Vec3 corner[3];
  };
  struct Candidate {
    double off;
    std::uint32_t point;
  };
  bool try_point(std::uint32_t u, double most_off);
  bool look_around(std::uint32_t u);
  bool may_go(std::uint32_t u, std::uint32_t v);
  bool take_fresh(std::uint32_t u, std::uint32_t v);
  bool hold_all(std::uint32_t u, double most_off);
  void execute(std::uint32_t u, std::uint32_t v);
  void drop_from(std::uint32_t point, std::uint32_t triangle);
  bool has(std::uint32_t triangle, std::uint32_t point) const;
  Vec3 point(std::uint32_t i) const { return exact_.point(i); }

  const Mesh& exact_;
  std::vector<std::uint32_t> corners_;  // numbers of the three corner points of each triangle
  // For each point: number of the triangles around the point (count_), and index of the first of these triangles in the list around_.
  std::vector<std::uint32_t> first_, count_;
  std::vector<std::uint32_t> around_;        // numbers of the triangles around each point
  std::vector<std::uint32_t> holds_, next_;  // linked lists: the first point assigned to each triangle, and the point after each point
  // For each point: whether it must still be tried, and whether its triangles have changed in this pass.
  std::vector<std::uint8_t> waits_, touched_;
  std::vector<std::uint32_t> mark_;  // for each point: the number of the last query that visited it
  std::uint32_t question_ = 0;
  // ---- data of the point that a removal is tried for
  std::vector<Around> star_;
  std::vector<std::uint32_t> ring_;
  std::vector<Candidate> candidates_;
  std::vector<Fresh> fresh_;
  std::vector<Held> held_;
};

}  // namespace kadr
