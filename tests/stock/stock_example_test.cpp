// The example at the head of stock/stock.h, line by line: it compiles, and gives the results that the header states.

#include <gtest/gtest.h>

#include "stock/stock.h"
#include "stock/surface/surface.h"

namespace kadr::stock_example_test {
namespace {

TEST(stock, is_used_as_its_header_says) {
  const std::shared_ptr<const Blank> blank = box_blank({{0, 0, 0}, {20, 10, 5}});
  const double cell = 1;
  const int threads = 1;
  const Vec3 from{-10, 5, 3}, to{30, 5, 3};
  ToolGeometry geometry;
  geometry.diameter = 4;
  geometry.flutes = 10;
  const ToolShape shape = shape_of(geometry);

  Stock stock(blank, cell, threads);
  const std::uint16_t tool = stock.add_tool(shape);
  stock.add({.from = from, .to = to, .tool = tool});
  const std::vector<Touch> touches = stock.cut();
  const Surface surface = surface_of(stock);

  EXPECT_TRUE(touches.empty());
  EXPECT_FALSE(surface.triangles.empty());
}

}  // namespace
}  // namespace kadr::stock_example_test
