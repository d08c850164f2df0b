#pragma once
// The helical surface of threads on an edge of a turned part, for display. It is used by stock/turned/turned_surface and
// stock/turned/turned_picture.

#include <functional>
#include <optional>
#include <vector>

#include "stock/turned/thread_groove.h"

namespace kadr {

/// An edge of the region of a turned part, with the number of what made it. Points of the half plane: x is the radius, y is Z, mm.
struct ShownEdge {
  Vec2 a, b;
  std::int32_t maker = -1;

  bool is_outer() const { return b.y > a.y; }  // the outside is to the right of an edge
  double radius(double z) const { return a.y == b.y ? a.x : a.x + (b.x - a.x) * (z - a.y) / (b.y - a.y); }
  double low() const { return std::min(a.y, b.y); }
  double high() const { return std::max(a.y, b.y); }
};

/// The threads that cut an edge, and the part of the edge that they reach.
struct ThreadedPart {
  std::vector<const ThreadGroove*> grooves;  // the deepest comes first
  double low = 0, high = 0;                  // Z, mm

  double pitch() const { return grooves.front()->lead; }
  /// Returns the radius of the surface at an angle (rad) and a Z of the edge, mm, and the number of what made it.
  std::pair<double, std::int32_t> at(const ShownEdge& edge, double angle, double z) const;
};

/// Returns the threads on an edge; nullopt if there is none.
std::optional<ThreadedPart> threads_on(const ShownEdge& edge, const std::vector<ThreadGroove>& threads);

/// How finely a thread is divided: chords in a full turn, the first chord that is shown (those before it are cut out), samples along Z per
/// lead.
struct ThreadMesh {
  int chords = 24, first = 0, steps = 6;
};

/// Adds the helical surface to a mesh. Its rows follow the helix, so that crests and roots are lines of the mesh; rows beyond the ends lie
/// on the ends. Triangles are counter-clockwise seen from outside, about Z.
///   add_point     adds a point at a chord (a number of 0 to `chords`, for the angle 2π · chord / chords), a radius and a Z, made by
///                 `maker`; returns its index, which must grow by one with each call
///   add_triangle  adds a triangle of three such indices
void add_thread(const ShownEdge& edge, const ThreadedPart& part, const ThreadMesh& mesh,
                const std::function<std::uint32_t(int chord, double radius, double z, std::int32_t maker)>& add_point,
                const std::function<void(std::uint32_t, std::uint32_t, std::uint32_t)>& add_triangle);

}  // namespace kadr
