#pragma once
// Decimation: removes points of a closed surface one by one, as long as no removed point is farther than allowed from the simplified
// surface. Used by stock/surface/simplified_surface.
//
//          ring                    Point u is merged into its neighbour v: in the triangles around u, v replaces u, and
//        ·──────·                  the two triangles with both of them vanish. Removed points are assigned to the
//       ╱ ╲    ╱ ╲                 triangle nearest to them. Before u goes, u and all points assigned to its triangles
//      ·── u ─▶ v ──·              are checked against the new triangles. So the distance of every point of the exact
//       ╲ ╱    ╲ ╱                 surface from the simplified one is known at all times (Kobbelt, Campagna and Seidel,
//        ·──────·                  A General Framework for Mesh Decimation, 1998).

#include <cstdint>
#include <vector>

#include "base/stop.h"
#include "stock/mesh/mesh.h"

namespace kadr {

class Decimation {
 public:
  /// Takes a closed mesh without doubled edges, and keeps a reference to it.
  explicit Decimation(const Mesh& exact);

  /// Removes points until every further removal would put a point farther than `most_off` mm from the surface, or until a stop is
  /// requested.
  void go(double most_off, const StopToken& stop);
  Mesh mesh() const;

 private:
  struct Around {
    std::uint32_t triangle;
    Vec3 normal;  // unit length, or {}
  };
  struct Held {
    std::uint32_t point;
    std::size_t by;  // number in fresh_
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
  void carry_out(std::uint32_t u, std::uint32_t v);
  void drop_from(std::uint32_t point, std::uint32_t triangle);
  bool has(std::uint32_t triangle, std::uint32_t point) const;
  Vec3 point(std::uint32_t i) const { return exact_.point(i); }

  const Mesh& exact_;
  std::vector<std::uint32_t> corners_;         // three per triangle
  std::vector<std::uint32_t> first_, count_;   // range of each point in around_
  std::vector<std::uint32_t> around_;          // triangles
  std::vector<std::uint32_t> holds_, next_;    // the first point assigned to each triangle, and the next one after each point
  std::vector<std::uint8_t> waits_, touched_;  // for each point: to be tried again; its triangles have changed in this pass
  std::vector<std::uint32_t> mark_;            // for each point: the last question that met it
  std::uint32_t question_ = 0;
  // For the point that is being tried:
  std::vector<Around> star_;
  std::vector<std::uint32_t> ring_;
  std::vector<Candidate> candidates_;
  std::vector<Fresh> fresh_;
  std::vector<Held> held_;
};

}  // namespace kadr
