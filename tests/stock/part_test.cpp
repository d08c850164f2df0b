// stock/part: the remaining stock compared with the desired part.

#include <gtest/gtest.h>

#include "stock/blank/mesh_blank.h"
#include "stock/part/part_compare.h"
#include "stock/stock_samples.h"
#include "stock/surface/surface.h"

namespace kadr::part_test {
namespace {

constexpr double cell = 0.5;
const Box3 block{{0, 0, -10}, {40, 30, 0}};

void mill(Stock& stock, std::uint16_t tool, double floor) {
  for (double y = 12.5; y < 20; y += 2.5) stock.add({{10, y, floor}, {30, y, floor}, tool});
  const Vec3 corners[] = {{10, 10, floor}, {30, 10, floor}, {30, 20, floor}, {10, 20, floor}, {10, 10, floor}};
  for (int i = 0; i < 4; ++i) stock.add({corners[i], corners[i + 1], tool});
}

/// Returns a pocket cut by a flat tool of 10 mm. Its size is 20 by 10 mm plus the tool's diameter, its floor is at `floor`, and one
/// wall is cut too deep by `beyond` mm.
Stock pocket(double floor, double beyond = 0, const Box3& blank = block, int threads = 2) {
  Stock stock(box_blank(blank), cell, threads);
  const std::uint16_t tool = stock.add_tool(test::tool_of(ToolKind::flat, 10));
  mill(stock, tool, floor);
  if (beyond > 0)
    stock.add({{30, 12, floor}, {30 + beyond, 12, floor}, tool}), stock.add({{30 + beyond, 12, floor}, {30 + beyond, 18, floor}, tool});
  (void)stock.cut();
  return stock;
}

PartComparison held(const Stock& stock, const Mesh& part) { return compare(stock, surface_of(stock), part); }

/// Computed with a tenth of the others' cell: practically exact.
Mesh good_part(const Box3& blank = block) {
  Stock stock(box_blank(blank), 0.2, 2);
  const std::uint16_t tool = stock.add_tool(test::tool_of(ToolKind::flat, 10));
  mill(stock, tool, -5);
  (void)stock.cut();
  return surface_of(stock);
}

TEST(part_compare, what_is_as_wanted_has_no_offence) {
  const PartComparison c = held(pocket(-5), good_part());
  EXPECT_LT(c.left_on.deepest, cell / 10);
  EXPECT_LT(c.gouged.deepest, cell / 10);
  EXPECT_LT(c.left_on.volume, 2);
  EXPECT_LT(c.gouged.volume, 2);
}

TEST(part_compare, a_floor_too_high_is_left_on) {
  const PartComparison c = held(pocket(-4.8), good_part());
  EXPECT_NEAR(c.left_on.deepest, 0.2, 0.01);
  EXPECT_NEAR(c.left_on.at.z, -4.8, 0.01);
  EXPECT_GE(c.left_on.sweep, 0);
  EXPECT_NEAR(c.left_on.volume, 0.2 * (30 * 20 - (4 - pi) * 25), 2);  // the corners have a radius of 5
  EXPECT_LT(c.gouged.deepest, cell / 10);
}

TEST(part_compare, a_wall_cut_into_is_gouged) {
  const Stock stock = pocket(-5, 0.3);
  const PartComparison c = held(stock, good_part());
  EXPECT_NEAR(c.gouged.deepest, 0.3, 0.03);
  EXPECT_NEAR(c.gouged.at.x, 35.3, 0.05);
  EXPECT_GE(std::size_t(c.gouged.sweep), stock.sweeps() - 2);
  EXPECT_GT(c.gouged.volume, 0.3 * 6 * 5 * 0.9);
  EXPECT_LT(c.left_on.deepest, cell / 10);
}

TEST(part_compare, a_part_that_sticks_out_of_the_blank_was_never_there) {
  const Box3 wider{{0, 0, -10}, {43, 30, 0}};
  const PartComparison c = held(pocket(-5), good_part(wider));
  EXPECT_NEAR(c.gouged.volume, 3 * 30 * 10, 3);
  EXPECT_NEAR(c.gouged.deepest, 3, 0.1);
  EXPECT_EQ(c.gouged.sweep, of_blank);
}

TEST(part_compare, what_was_not_cut_at_all_is_left_on) {
  const Stock stock(box_blank(block), cell, 2);
  const PartComparison c = held(stock, good_part());
  EXPECT_NEAR(c.left_on.volume, 5 * (30 * 20 - (4 - pi) * 25), 15);
  EXPECT_NEAR(c.left_on.deepest, 5, 0.1);
  EXPECT_EQ(c.left_on.sweep, of_blank);
}

TEST(part_compare, threads_change_nothing) {
  const Mesh part = good_part();
  const PartComparison one = held(pocket(-4.8, 0.3, block, 1), part), three = held(pocket(-4.8, 0.3, block, 3), part);
  EXPECT_EQ(one.deviation, three.deviation);
  EXPECT_EQ(one.gouged.volume, three.gouged.volume);
  EXPECT_EQ(one.gouged.deepest, three.gouged.deepest);
  EXPECT_EQ(one.left_on.volume, three.left_on.volume);
  EXPECT_EQ(one.left_on.at.x, three.left_on.at.x);
  EXPECT_EQ(one.left_on.sweep, three.left_on.sweep);
}

}  // namespace
}  // namespace kadr::part_test
