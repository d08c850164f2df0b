#pragma once
// Computes the distances of a point from four triangles, two triangles at a time, by the method of stock/part/triangle_distance. Used by
// stock/part/nearest_triangle.

#include <cstddef>
#include <cstdint>

#include "base/matrix.h"

namespace kadr {

/// A block of four triangles. The same coordinate of all four triangles is stored contiguously, so that one vector can load it.
struct FourTriangles {
  alignas(16) float corner[3][3][4];  // indices: number of the corner, axis, number of the triangle
};

/// One triangle in a block of four; `lane` (0 to 3) is the number of the triangle in the block.
struct OneOfFour {
  const FourTriangles* four;
  std::uint32_t lane;
};

namespace lanes {

using Two = double __attribute__((vector_size(16), may_alias));

/// Two vectors in space, one for each of two triangles.
struct TwoPlaces {
  Two x, y, z;
};

inline TwoPlaces operator-(const TwoPlaces& a, const TwoPlaces& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Two dot(const TwoPlaces& a, const TwoPlaces& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline TwoPlaces cross(const TwoPlaces& a, const TwoPlaces& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline Two square_to_segment(const TwoPlaces& from, const TwoPlaces& delta) {
  const Two none{}, one = none + 1.0, length_squared = dot(delta, delta);
  Two share = -dot(from, delta) / length_squared;
  share = share < none ? none : share;
  share = one < share ? one : share;
  share = length_squared > none ? share : none;
  const TwoPlaces nearest{from.x + share * delta.x, from.y + share * delta.y, from.z + share * delta.z};
  return dot(nearest, nearest);
}

/// Returns the squared distances in mm² of the point from two triangles. The corners are given relative to the point.
inline Two square_to_triangle(const TwoPlaces (&corner)[3]) {
  const Two none{};
  TwoPlaces side[3];
  for (int k = 0; k < 3; ++k) side[k] = corner[(k + 1) % 3] - corner[k];
  const TwoPlaces normal = cross(side[0], side[1]);
  const Two size = dot(normal, normal), off = dot(corner[0], normal);
  auto over = size > none;
  for (int k = 0; k < 3; ++k) over &= dot(cross(corner[k], corner[(k + 1) % 3]), normal) >= none;
  Two least = square_to_segment(corner[0], side[0]);
  for (int k = 1; k < 3; ++k) {
    const Two square = square_to_segment(corner[k], side[k]);
    least = square < least ? square : least;
  }
  const Two to_plane = off * off / size;
  return over ? to_plane : least;
}

}  // namespace lanes

/// Computes the squared distances in mm² from the point to an even number of triangles. `pair(k, d, i)` must return the coordinate d of
/// corner k for the triangles i and i + 1.
template <std::size_t count>
inline void squares_to_pairs(const auto& pair, const Vec3& point, double (&squares)[count]) {
  for (std::size_t i = 0; i < count; i += 2) {
    lanes::TwoPlaces seen[3];
    for (std::size_t k = 0; k < 3; ++k) seen[k] = {pair(k, 0, i) - point.x, pair(k, 1, i) - point.y, pair(k, 2, i) - point.z};
    const lanes::Two square = lanes::square_to_triangle(seen);
    squares[i] = square[0], squares[i + 1] = square[1];
  }
}

/// Does the same as squares_to_pairs(), for triangles that may be in different blocks.
///   law  the result equals that of kadr::square_to_triangle(), bit for bit   (tests/stock/nearest_triangle_test)
template <std::size_t count>
inline void squares_to_triangles(const OneOfFour (&one)[count], const Vec3& point, double (&squares)[count]) {
  const auto place = [&](std::size_t k, std::size_t d, std::size_t i) { return double(one[i].four->corner[k][d][one[i].lane]); };
  squares_to_pairs(
      [&](std::size_t k, std::size_t d, std::size_t i) {
        return lanes::Two{place(k, d, i), place(k, d, i + 1)};
      },
      point, squares);
}

/// Does the same as squares_to_pairs(), for all triangles of one block, whose coordinates are contiguous.
inline void squares_to_all(const FourTriangles& four, const Vec3& point, double (&squares)[4]) {
  using TwoFloats = float __attribute__((vector_size(8), may_alias));
  const auto pair = [&](std::size_t k, std::size_t d, std::size_t i) {
    return __builtin_convertvector(*reinterpret_cast<const TwoFloats*>(four.corner[k][d] + i), lanes::Two);
  };
  squares_to_pairs(pair, point, squares);
}

}  // namespace kadr
