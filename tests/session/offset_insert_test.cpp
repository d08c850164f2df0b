// Inserts from rows of a lathe's offset table (spec/fanuc-t 7.1).

#include "session/cutting/offset_insert.h"

#include <gtest/gtest.h>

#include "config/tools/tool_library.h"

namespace kadr::offset_insert_test {
namespace {

ToolOffset row_of(double radius, double wear, double tip) {
  ToolOffset row;
  row.radius = radius, row.radius_wear = wear, row.tip_position = tip;
  return row;
}

TEST(OffsetInsert, TipsPointAsTheManualDrawsThem) {
  constexpr int dx[] = {1, 1, -1, -1, 0, 1, 0, -1}, dz[] = {1, -1, -1, 1, 1, 0, -1, 0};
  for (int tip = 1; tip <= 8; ++tip) {
    const auto g = insert_of_offset(row_of(0.8, 0, tip), 3);
    ASSERT_TRUE(g);
    EXPECT_EQ(g->insert.tip_x, dx[tip - 1]) << tip;
    EXPECT_EQ(g->insert.tip_z, dz[tip - 1]) << tip;
    EXPECT_EQ(g->number, 3U);
    EXPECT_EQ(tool_fault_message(*g), "");
  }
}

// docs/commands/cut.md, "Turning tools": the column LinuxCNC Q
TEST(OffsetInsert, LinuxCncNumbersTheTipsInItsOwnOrder) {
  constexpr int dx[] = {-1, -1, 1, 1, 0, -1, 0, 1}, dz[] = {1, -1, -1, 1, 1, 0, -1, 0};
  for (int tip = 1; tip <= 8; ++tip) {
    const auto g = insert_of_offset(row_of(0.8, 0, tip), 3, TipNumbers::linuxcnc);
    ASSERT_TRUE(g);
    EXPECT_EQ(g->insert.tip_x, dx[tip - 1]) << tip;
    EXPECT_EQ(g->insert.tip_z, dz[tip - 1]) << tip;
  }
}

TEST(OffsetInsert, TheWearOfTheNoseCounts) { EXPECT_DOUBLE_EQ(insert_of_offset(row_of(0.8, -0.1, 3), 1)->corner, 0.7); }

TEST(OffsetInsert, TheCentreAsTipIsARoundInsert) {
  const auto g = insert_of_offset(row_of(4, 0, 0), 1);
  ASSERT_TRUE(g);
  EXPECT_EQ(g->angle, 0);
  EXPECT_EQ(g->corner, 4);
  EXPECT_EQ(tool_fault_message(*g), "");
}

TEST(OffsetInsert, ASharpNoseNeedsATip) {
  EXPECT_TRUE(insert_of_offset(row_of(0, 0, 3), 1));
  EXPECT_FALSE(insert_of_offset(row_of(0, 0, 0), 1));
}

TEST(OffsetInsert, LargeNosesGetLongerEdges) { EXPECT_EQ(tool_fault_message(*insert_of_offset(row_of(6, 0, 3), 1)), ""); }

}  // namespace
}  // namespace kadr::offset_insert_test
