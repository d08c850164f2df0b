// stock/part/nearest_triangle: returns the least of the distances to all triangles, bit by bit.

#include "stock/part/nearest_triangle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "stock/part/triangle_distance.h"
#include "stock/some_meshes.h"

namespace kadr::nearest_triangle_test {
namespace {

using namespace test;

double by_all(const Mesh& mesh, const Vec3& at) {
  double least = std::numeric_limits<double>::max();
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    Vec3 seen[3];
    for (std::size_t k = 0; k < 3; ++k) seen[k] = mesh.corner(t, k) - at;
    least = std::min(least, square_to_triangle(seen));
  }
  return std::sqrt(least);
}

/// Compares points near the triangles, on their corners, inside and far away, in an order for which no hint is prepared.
void expect_nearest(const Mesh& mesh, int threads = 1) {
  const NearestTriangle nearest(mesh, threads);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  std::uint32_t hint = 0;
  for (int i = 0; i < 3000; ++i) {
    const double reach = std::pow(10.0, -6 + i % 9);
    const Vec3 corner = mesh.corner(std::size_t(random()) % mesh.triangle_count(), std::size_t(i) % 3);
    const Vec3 at = i % 10 == 0 ? corner : corner + reach * Vec3{any(random), any(random), any(random)};
    ASSERT_EQ(nearest.distance(at, hint), by_all(mesh, at)) << at.x << ' ' << at.y << ' ' << at.z;
  }
}

TEST(nearest_triangle, is_the_least_of_all) {
  expect_nearest(torus_mesh(12, 10, 4));
  expect_nearest(box_mesh({-50, -5, 0}, {50, 5, 0.01}));
  expect_nearest(together(torus_mesh(9, 10, 4), turned(box_mesh({0, 0, 0}, {1, 1, 1}), [](const Vec3& p) {
                            return p + Vec3{500, 20, -3};
                          })));
}

/// Some triangles at the poles have no area.
TEST(nearest_triangle, of_triangles_without_area) { expect_nearest(sphere_mesh(12, 10)); }

/// Fewer triangles than a node can hold, and one more than fills some nodes.
TEST(nearest_triangle, of_any_number_of_triangles) {
  for (const std::size_t count : {1U, 2U, 3U, 4U, 5U, 31U, 32U, 33U, 255U, 256U, 257U}) {
    Mesh mesh = torus_mesh(12, 10, 4);
    mesh.triangles.resize(3 * count);
    expect_nearest(mesh);
  }
}

TEST(nearest_triangle, built_by_any_number_of_threads) {
  for (const int threads : {2, 3, 8}) expect_nearest(torus_mesh(45, 10, 4), threads);
}

}  // namespace
}  // namespace kadr::nearest_triangle_test
