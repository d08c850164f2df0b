// stock/surface/simplified_surface: fewer triangles, still closed, and never further from the original than allowed.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "stock/mesh/mesh_edges.h"
#include "stock/some_meshes.h"
#include "stock/some_tools.h"
#include "stock/stock_samples.h"
#include "stock/surface/simplified_surface.h"
#include "stock/surface/surface.h"

namespace kadr::simplify_test {
namespace {

using namespace test;

void expect_simple(const Mesh& exact, double allowed, const SimplifiedSurface& simple) {
  const MeshEdges edges = edges_of(simple.mesh);
  EXPECT_EQ(edges.open, 0U);
  EXPECT_EQ(edges.doubled, 0U);
  EXPECT_LE(simple.off, allowed);
  EXPECT_LE(simple.mesh.triangle_count(), exact.triangle_count());
  EXPECT_GT(simple.mesh.triangle_count(), 3U);
  EXPECT_LE(farthest_off(exact, simple.mesh, 0.05, {}), allowed + 1e-4);  // finer than its own measurement
  EXPECT_LE(farthest_off(simple.mesh, exact, 0.05, {}), allowed + 1e-4);
  EXPECT_NEAR(volume_of(simple.mesh), volume_of(exact), allowed * area_of(exact));
}

TEST(simplified_surface, a_pocket_is_a_few_triangles) {
  const auto stock = cut_along(box_blank({{0, 0, -10}, {40, 30, 0}}), 0.5, tool_of(ToolKind::flat, 10),
                               {{10, 10, 5}, {10, 10, -5}, {30, 10, -5}, {30, 20, -5}, {10, 20, -5}, {10, 10, -5}});
  const Surface surface = surface_of(*stock);
  const SimplifiedSurface simple = simplified_surface(surface, {0.01, 1, {}});
  expect_simple(surface, 0.01, simple);
  EXPECT_LT(simple.mesh.triangle_count(), surface.triangle_count() / 20);
}

TEST(simplified_surface, a_torus_by_what_is_allowed) {
  const Mesh exact = torus_mesh(64, 10, 3);
  std::size_t before = exact.triangle_count();
  for (const double allowed : {0.001, 0.01, 0.1}) {
    const SimplifiedSurface simple = simplified_surface(exact, {allowed, 2, {}});
    expect_simple(exact, allowed, simple);
    EXPECT_LE(simple.mesh.triangle_count(), before);
    before = simple.mesh.triangle_count();
  }
  EXPECT_LT(before, exact.triangle_count() / 4);
}

TEST(simplified_surface, the_same_for_any_number_of_threads) {
  const Mesh exact = torus_mesh(32, 10, 3);
  const SimplifiedSurface one = simplified_surface(exact, {0.05, 1, {}}), three = simplified_surface(exact, {0.05, 3, {}});
  EXPECT_EQ(one.mesh.points, three.mesh.points);
  EXPECT_EQ(one.mesh.triangles, three.mesh.triangles);
  EXPECT_EQ(one.off, three.off);
}

TEST(simplified_surface, a_body_of_four_triangles_stays) {
  Mesh exact;
  for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) add_point(exact, p);
  exact.triangles = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  EXPECT_EQ(simplified_surface(exact, {10, 1, {}}).mesh.triangles, exact.triangles);
  EXPECT_TRUE(simplified_surface({}, {10, 1, {}}).mesh.triangles.empty());
}

/// Random tools along random paths leave thin walls and points.
RC_GTEST_PROP(simplified_surface, whatever_was_cut, ()) {
  Chance chance(*rc::gen::arbitrary<std::uint64_t>());
  Stock stock(box_blank({{0, 0, -6}, {10, 10, 0}}), 0.4, 1);
  for (int i = 0; i < 6; ++i) {
    const std::uint16_t tool = stock.add_tool(some_tool(chance, SomeTool(chance.below(some_tools))));
    Sweep sweep = some_move(chance);
    sweep.tool = tool;
    stock.add(sweep);
  }
  stock.cut();
  const Surface surface = surface_of(stock);
  const double allowed = std::pow(10, chance.between(-3, -0.5));
  const SimplifiedSurface simple = simplified_surface(surface, {allowed, 1, {}});
  const MeshEdges edges = edges_of(simple.mesh);
  RC_ASSERT(edges.open == 0U);
  RC_ASSERT(edges.doubled == 0U);
  RC_ASSERT(simple.off <= allowed);
}

}  // namespace
}  // namespace kadr::simplify_test
