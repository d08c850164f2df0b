// stock/blank/mesh_blank: makes a blank from a closed mesh, and a surface from the blank.

#include "stock/blank/mesh_blank.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "stock/mesh/mesh_edges.h"
#include "stock/mesh/mesh_index.h"
#include "stock/mesh/mesh_repair.h"
#include "stock/some_meshes.h"
#include "stock/some_tools.h"
#include "stock/stock_samples.h"
#include "stock/surface/surface.h"

namespace kadr::mesh_blank_test {
namespace {

using namespace test;

Mesh solid(const Mesh& mesh) { return solid_of(mesh, {}).value().mesh; }

/// Returns the volume of the blank's surface with this cell, divided by the volume of the mesh.
double volume_again(const Mesh& mesh, double cell) {
  const Surface surface = surface_of(Stock(mesh_blank(mesh), cell, 2));
  const MeshEdges edges = edges_of(surface);
  EXPECT_EQ(edges.open, 0U);
  EXPECT_EQ(edges.doubled, 0U);
  return volume_of(surface) / volume_of(mesh);
}

TEST(mesh_blank, a_box_is_as_the_box) {
  const Box3 box{{0, 0, -5}, {10, 8, 0}};
  const Stock by_mesh(mesh_blank(box_mesh(box.least, box.most)), 0.5, 2), plain(box_blank(box), 0.5, 2);
  const Surface a = surface_of(by_mesh), b = surface_of(plain);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.triangles, b.triangles);
}

TEST(mesh_blank, forms_keep_their_volume) {
  const Mesh cube = turned(box_mesh({-5, -5, -5}, {5, 5, 5}), [](const Vec3& p) {
    const Vec3 q{0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y, p.z};
    return Vec3{q.x, 0.28 * q.y - 0.96 * q.z, 0.96 * q.y + 0.28 * q.z};
  });
  EXPECT_NEAR(volume_again(cube, 0.5), 1, 2e-3);
  EXPECT_NEAR(volume_again(solid(sphere_mesh(40, 10)), 0.5), 1, 1e-3);
  EXPECT_NEAR(volume_again(torus_mesh(60, 10, 4), 0.5), 1, 2e-3);
}

/// Points and edges of the mesh lie exactly on lattice lines; faces of two bodies coincide.
TEST(mesh_blank, lines_through_edges_and_points) {
  const Mesh cube = box_mesh({-4, -4, -4}, {4, 4, 4});
  for (const double cell : {1.0, 0.5, 0.8}) {
    EXPECT_NEAR(volume_again(together(cube, turned(cube, [&](const Vec3& p) { return p + Vec3{8, cell / 2, 0}; })), cell), 1, 1e-5) << cell;
    EXPECT_NEAR(volume_again(solid(sphere_mesh(16, 4 + cell / 2)), cell), 1, 0.02 * cell) << cell;
  }
}

TEST(mesh_blank, a_hollow_and_bodies_that_overlap) {
  const Mesh outer = box_mesh({0, 0, 0}, {20, 20, 20}), inner = box_mesh({5, 5, 5}, {10, 10, 10}),
             second = box_mesh({15, 0, 0}, {30, 20, 20});
  EXPECT_NEAR(volume_of(surface_of(Stock(mesh_blank(together(outer, inside_out(inner))), 0.7, 2))), 8000 - 125, 0.1);
  EXPECT_NEAR(volume_of(surface_of(Stock(mesh_blank(together(outer, second)), 0.7, 2))), 30 * 20 * 20, 0.1);
}

RC_GTEST_PROP(mesh_blank, every_line_goes_in_as_often_as_out, (unsigned seed)) {
  Chance chance(seed);
  Mesh mesh = torus_mesh(std::uint32_t(3 + chance.below(12)), 10, 4);
  const bool on_grid = chance.below(2) == 0;  // many edges at right angles to the axes, and lines through points
  for (float& p : mesh.points) p = on_grid ? std::round(p) : p + float(chance.between(-1, 1));
  for (int family = 0; family < 3; ++family) {
    const MeshIndex index(mesh, family);
    for (int i = 0; i < 300; ++i) {
      std::vector<MeshHit> hits;
      const double u = chance.between(-15, 15), v = chance.between(-15, 15);
      index.hits(on_grid ? std::round(u) : u, on_grid ? std::round(v) : v, hits);
      int turns = 0;
      for (const MeshHit& h : hits) turns += h.turn;
      RC_ASSERT(turns == 0);
    }
  }
}

/// The cut part is the blank of the next set-up.
TEST(mesh_blank, a_cut_part_is_cut_again) {
  const auto blank = cylinder_blank({15, 15}, -10, 0, 28);
  const auto first = cut_along(blank, 0.5, tool_of(ToolKind::ball, 6), {{0, 4, -4.03}, {30, 20, -3.1}, {8, 31, -2}});
  const Surface left = surface_of(*first);
  const Mesh part = solid(left);
  const Surface again = surface_of(Stock(mesh_blank(part), 0.37, 2));
  EXPECT_EQ(edges_of(again).open, 0U);
  EXPECT_EQ(edges_of(again).doubled, 0U);
  EXPECT_NEAR(volume_of(again) / volume_of(left), 1, 5e-4);
  const auto second = cut_along(mesh_blank(part), 0.37, tool_of(ToolKind::flat, 5), {{15, -5, -6.2}, {15, 35, -6.2}});
  const Surface end = surface_of(*second);
  EXPECT_EQ(edges_of(end).open, 0U);
  EXPECT_LT(volume_of(end), volume_of(again));
}

}  // namespace
}  // namespace kadr::mesh_blank_test
