// stock/blank/blank_window, stock/mesh/mesh_within: the result inside a window equals the result of the whole there.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "stock/blank/blank_window.h"
#include "stock/blank/mesh_blank.h"
#include "stock/mesh/mesh_edges.h"
#include "stock/mesh/mesh_within.h"
#include "stock/part/part_compare.h"
#include "stock/some_meshes.h"
#include "stock/stock_samples.h"
#include "stock/surface/surface.h"

namespace kadr::window_test {
namespace {

using namespace test;

TEST(mesh_within, of_boxes_their_common_part) {
  const Mesh mesh = box_mesh({0, 0, 0}, {4, 5, 6});
  EXPECT_NEAR(mesh_within(mesh, {{1, 1, 1}, {2, 3, 5}}).volume, 8, 1e-9);
  EXPECT_NEAR(mesh_within(mesh, {{1, 1, 1}, {2, 3, 5}}).area, 0, 1e-9);
  EXPECT_NEAR(mesh_within(mesh, {{-1, -1, -1}, {5, 6, 7}}).volume, 120, 1e-6);
  EXPECT_NEAR(mesh_within(mesh, {{-1, -1, -1}, {5, 6, 7}}).area, 148, 1e-6);
  EXPECT_NEAR(mesh_within(mesh, {{1, 1, 1}, {2, 3, 6}}).volume, 10, 1e-9);
  EXPECT_NEAR(mesh_within(mesh, {{0, 0, 0}, {4, 5, 6}}).volume, 120, 1e-9);
  EXPECT_NEAR(mesh_within(mesh, {{3, 4, 5}, {9, 9, 9}}).volume, 1, 1e-9);
  EXPECT_NEAR(mesh_within(mesh, {{3, 4, 5}, {9, 9, 9}}).area, 3, 1e-9);
  EXPECT_EQ(mesh_within(mesh, {{7, 7, 7}, {9, 9, 9}}).volume, 0);
}

RC_GTEST_PROP(mesh_within, boxes_beside_each_other_add_up, ()) {
  const Mesh mesh = torus_mesh(24, 7, 2);
  const auto place = [](int most) { return *rc::gen::inRange(-most, most) / 100.0; };
  const double parting = place(900);
  const int axis = *rc::gen::inRange(0, 3);
  Box3 low{{place(900) - 9, place(900) - 9, place(200) - 2}, {place(900) + 9, place(900) + 9, place(200) + 2}}, high = low, all = low;
  along(low.most, axis) = along(high.least, axis) = std::clamp(parting, along(all.least, axis), along(all.most, axis));
  RC_ASSERT(std::abs(mesh_within(mesh, low).volume + mesh_within(mesh, high).volume - mesh_within(mesh, all).volume) < 1e-6);
  const double beyond = volume_of(mesh) - mesh_within(mesh, all).volume;
  RC_ASSERT(beyond > -1e-4);
}

TEST(blank_window, volumes) {
  const Box3 quarter{{3, 4, -6}, {50, 50, 50}};
  EXPECT_NEAR(blank_within(box_blank(block), {{10, 20, -5}, {20, 25, 50}})->volume(), 250, 1e-6);
  const double exact = pi * 100 * 6 / 4;
  EXPECT_NEAR(blank_within(cylinder_blank({3, 4}, -12, 0, 20), quarter)->volume(), exact, 1e-4 * exact);
  EXPECT_EQ(blank_within(box_blank(block), {{100, 0, -5}, {120, 25, 0}}), nullptr);
}

TEST(blank_window, the_stock_is_the_blank_there) {
  const auto torus = mesh_blank(torus_mesh(48, 7, 2));
  const std::shared_ptr<const Blank> blanks[] = {torus, box_blank({{-9, -9, -2}, {9, 9, 2}}), cylinder_blank({0, 0}, -2, 2, 18)};
  for (const auto& blank : blanks) {
    const auto window = blank_within(blank, {{0.3, -20, -1.1}, {6.7, 3.3, 20}});
    const Surface surface = surface_of(Stock(window, 0.25, 2));
    EXPECT_EQ(edges_of(surface).open, 0U);
    EXPECT_EQ(edges_of(surface).doubled, 0U);
    EXPECT_NEAR(volume_of(surface), window->volume(), 2e-3 * window->volume());
  }
}

/// Returns a block with a pocket in its middle; the stock may be a window of the block.
std::unique_ptr<Stock> with_pocket(std::shared_ptr<const Blank> blank, double cell, double floor) {
  return cut_along(std::move(blank), cell, tool_of(ToolKind::flat, 10),
                   {{30, 30, 5}, {30, 30, floor}, {70, 30, floor}, {70, 40, floor}, {30, 40, floor}, {30, 30, floor}});
}

TEST(blank_window, is_cut_as_the_whole_is) {
  const Box3 window{{25.3, 20, -9.7}, {50.1, 32.6, 0}};
  const auto whole = with_pocket(box_blank(block), 0.5, -5), part = with_pocket(blank_within(box_blank(block), window), 0.1, -5);
  // Half of a slot of 10 mm with a round end, from X 25 to the end of the window; above Y 32.6 the slot continues.
  const double left = volume_of(surface_of(*part)), coarse = mesh_within(surface_of(*whole), window).volume;
  EXPECT_NEAR(left, coarse, 0.002 * coarse);
  double exact = 0;  // volume of the slot inside the window, summed in strips
  constexpr int strips = 20'000;
  for (int i = 0; i < strips; ++i) {
    const double y = 20 + (i + 0.5) * 12.6 / strips, off_centre = y - 30;
    if (std::abs(off_centre) < 5)
      exact += (50.1 - std::max(25.3, 30 - (off_centre < 0 ? std::sqrt(25 - off_centre * off_centre) : 5.0))) * 5 * 12.6 / strips;
  }
  EXPECT_NEAR(volume_of(surface_of(Stock(part->blank().volume() > 0 ? blank_within(box_blank(block), window) : nullptr, 0.1, 1))) - left,
              exact, 0.001 * exact);
}

TEST(window_faces, where_the_blank_ends_there_is_none) {
  const WindowFaces faces({{10, 0, -5}, {20, 100, 0}}, block);
  EXPECT_TRUE(faces.hold({10, 50, -1}));
  EXPECT_TRUE(faces.hold({20, 50, -1}));
  EXPECT_TRUE(faces.hold({15, 50, -5}));
  EXPECT_FALSE(faces.hold({15, 0, -1}));
  EXPECT_FALSE(faces.hold({15, 100, -1}));
  EXPECT_FALSE(faces.hold({15, 50, 0}));
  EXPECT_FALSE(faces.hold({15, 50, -4.9}));
}

TEST(part_compare, of_a_window_only_what_lies_in_it) {
  const Surface part = surface_of(*with_pocket(box_blank(block), 0.5, -5));
  const Box3 window{{40, 20, -9}, {60, 60, 0}};
  const auto stock = with_pocket(blank_within(box_blank(block), window), 0.25, -4.8);
  const WindowFaces faces(window, block);
  const PartComparison held = compare(*stock, surface_of(*stock), part, &faces);
  EXPECT_NEAR(held.left_on.deepest, 0.2, 0.002);
  EXPECT_NEAR(held.left_on.volume, 20 * 20 * 0.2, 0.5);
  EXPECT_LT(held.gouged.deepest, 0.02);
  EXPECT_LT(held.gouged.volume, 0.1);
}

TEST(part_compare, what_a_comparison_takes_grows_with_the_part) {
  const Mesh near = box_mesh({10, 10, -10}, {20, 20, -5}), far = box_mesh({-500, -500, -500}, {500, 500, 500});
  EXPECT_LT(bytes_of_comparison(block, 0.5, near, ComparedPart::whole), 3e5);
  EXPECT_GT(bytes_of_comparison(block, 0.5, far, ComparedPart::whole), 20 * bytes_of_comparison(block, 0.5, near, ComparedPart::whole));
  // With a window the lattice keeps its size; only the number of its lines that the part can meet grows.
  EXPECT_LT(10 * bytes_of_comparison(block, 0.5, far, ComparedPart::window), bytes_of_comparison(block, 0.5, far, ComparedPart::whole));
}

}  // namespace
}  // namespace kadr::window_test
