#pragma once
// Meshes for the tests of meshes and of the blanks built from them.

#include <cmath>
#include <cstdint>

#include "stock/mesh/mesh.h"

namespace kadr::test {

inline void add_point(Mesh& mesh, const Vec3& p) {
  for (const double v : {p.x, p.y, p.z}) mesh.points.push_back(float(v));
}

/// Returns a box of twelve triangles.
inline Mesh box_mesh(const Vec3& least, const Vec3& most) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) add_point(mesh, {(i & 1) ? most.x : least.x, (i & 2) ? most.y : least.y, (i & 4) ? most.z : least.z});
  mesh.triangles = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  return mesh;
}

/// Returns a grid of `wide` by `deep` points that is closed in both directions.
template <class Place>
Mesh ring_mesh(std::uint32_t wide, std::uint32_t deep, const Place& place) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < wide; ++i)
    for (std::uint32_t j = 0; j < deep; ++j) add_point(mesh, place(2 * pi * i / wide, 2 * pi * j / deep));
  const auto id = [&](std::uint32_t i, std::uint32_t j) { return i % wide * deep + j % deep; };
  for (std::uint32_t i = 0; i < wide; ++i)
    for (std::uint32_t j = 0; j < deep; ++j)
      for (const std::uint32_t p : {id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j), id(i + 1, j + 1), id(i, j + 1)})
        mesh.triangles.push_back(p);
  return mesh;
}

inline Mesh torus_mesh(std::uint32_t fine, double big, double small) {
  return ring_mesh(2 * fine, fine, [&](double a, double b) {
    return Vec3{(big + small * std::cos(b)) * std::cos(a), (big + small * std::cos(b)) * std::sin(a), small * std::sin(b)};
  });
}

/// The triangles at the poles have two corners at the same point, as many programs write them.
inline Mesh sphere_mesh(std::uint32_t fine, double radius) {
  Mesh mesh;
  const auto place = [&](std::uint32_t i, std::uint32_t j) {
    const double a = 2 * pi * (i % (2 * fine)) / (2 * fine), b = pi * j / fine;
    if (j == 0 || j == fine) return Vec3{0, 0, j == 0 ? -radius : radius};
    return Vec3{radius * std::sin(b) * std::cos(a), radius * std::sin(b) * std::sin(a), -radius * std::cos(b)};
  };
  for (std::uint32_t i = 0; i < 2 * fine; ++i)
    for (std::uint32_t j = 0; j < fine; ++j)
      for (const Vec3& p : {place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j), place(i + 1, j + 1), place(i, j + 1)}) {
        mesh.triangles.push_back(std::uint32_t(mesh.point_count()));
        add_point(mesh, p);
      }
  return mesh;
}

inline Mesh together(Mesh a, const Mesh& b) {
  const std::uint32_t base = std::uint32_t(a.point_count());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const std::uint32_t t : b.triangles) a.triangles.push_back(base + t);
  return a;
}

inline Mesh inside_out(Mesh mesh) {
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) std::swap(mesh.triangles[3 * t + 1], mesh.triangles[3 * t + 2]);
  return mesh;
}

template <class Turn>
Mesh turned(Mesh mesh, const Turn& turn) {
  for (std::size_t i = 0; i < mesh.point_count(); ++i) {
    const Vec3 p = turn(mesh.point(i));
    mesh.points[3 * i] = float(p.x), mesh.points[3 * i + 1] = float(p.y), mesh.points[3 * i + 2] = float(p.z);
  }
  return mesh;
}

}  // namespace kadr::test
