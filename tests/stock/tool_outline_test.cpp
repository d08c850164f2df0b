// Outlines of tools: as wide and as high as the tool, and rising.

#include "stock/tool/tool_outline.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace kadr::tool_outline_test {
namespace {

ToolGeometry tool(ToolKind kind) {
  ToolGeometry g;
  g.kind = kind, g.diameter = 10, g.flutes = 20, g.length = 50;
  return g;
}

TEST(ToolOutline, RisesFromTheTipToTheTop) {
  for (const ToolKind kind :
       {ToolKind::flat, ToolKind::ball, ToolKind::bull, ToolKind::drill, ToolKind::taper, ToolKind::chamfer, ToolKind::tslot}) {
    ToolGeometry g = tool(kind);
    g.corner = kind == ToolKind::bull ? 2 : 0;
    g.angle = kind == ToolKind::taper ? 5 : 118;
    g.holder = {{30, 0}, {40, 15}};
    const auto outline = outline_of(g);
    ASSERT_GT(outline.size(), 3U) << int(kind);
    EXPECT_EQ(outline.front().diameter, 0) << int(kind);
    EXPECT_NEAR(outline.front().height, 0, 1e-9) << int(kind);
    EXPECT_EQ(outline.back(), (ProfilePoint{40, 65})) << int(kind);
    EXPECT_TRUE(std::is_sorted(outline.begin(), outline.end(), [](const auto& a, const auto& b) { return a.height < b.height; }))
        << int(kind);
  }
}

TEST(ToolOutline, OfABallIsRound) {
  for (const ProfilePoint& p : outline_of(tool(ToolKind::ball))) {
    if (p.height > 5 || p.diameter == 0) continue;
    const double r = p.diameter / 2, h = p.height - 5;
    EXPECT_NEAR(r * r + h * h, 25, 1e-9);
  }
}

TEST(ToolOutline, OfATurningToolOrNoneIsEmpty) {
  EXPECT_TRUE(outline_of(tool(ToolKind::turning)).empty());
  EXPECT_TRUE(outline_of(ToolGeometry{}).empty());
}

}  // namespace
}  // namespace kadr::tool_outline_test
