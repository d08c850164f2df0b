#pragma once
// Decimation: points of a closed surface go, one by one, as long as none of them is farther than allowed from what is left. For
// stock/surface/simplified_surface.
//
//          ring                    A point u goes into a neighbour v: the triangles around u get the corner v instead, and the two between
//        ·──────·                  u and v go. Points that have gone are held by the triangle nearest to them; before u goes, all that its
//       ╱ ╲    ╱ ╲                 triangles hold, and u itself, are held against the triangles that would be there. So the distance of
//      ·── u ─▶ v ──·              every point of the exact surface from the simple one is known at all times (Kobbelt, Campagna and
//       ╲ ╱    ╲ ╱                 Seidel, A General Framework for Mesh Decimation, 1998).
//        ·──────·

#include <cstdint>
#include <vector>

#include "base/stop.h"
#include "stock/mesh/mesh.h"

namespace kadr {

class Decimation {
 public:
  /// Closed, no edge doubled. Keeps a reference to it.
  explicit Decimation(const Mesh& exact);

  /// Nothing else can go without a point being farther than that, mm, from the surface; or asked to stop.
  void go(double most_off, const StopToken& stop);
  Mesh mesh() const;

 private:
  struct Around {
    std::uint32_t triangle;
    Vec3 normal;  // of length 1, or {}
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
  std::vector<std::uint32_t> corners_;         // three a triangle
  std::vector<std::uint32_t> first_, count_;   // of each point, into around_
  std::vector<std::uint32_t> around_;          // triangles
  std::vector<std::uint32_t> holds_, next_;    // the first point that a triangle holds, and after each point the next
  std::vector<std::uint8_t> waits_, touched_;  // of each point: to be tried again; its triangles have changed in this pass
  std::vector<std::uint32_t> mark_;            // of each point: the last question in which it was met
  std::uint32_t question_ = 0;
  // Of the point that is tried:
  std::vector<Around> star_;
  std::vector<std::uint32_t> ring_;
  std::vector<Candidate> candidates_;
  std::vector<Fresh> fresh_;
  std::vector<Held> held_;
};

}  // namespace kadr
