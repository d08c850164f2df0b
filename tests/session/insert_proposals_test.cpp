// session/insert_proposals: turning tools of comments.

#include "session/insert_proposals.h"

#include <gtest/gtest.h>

#include "config/tools/tool_library.h"

namespace kadr::insert_proposals_test {
namespace {

TEST(InsertProposals, TheCommentThatTellsMostCounts) {
  const InsertProposals found({{1, "(T01 OD TURN)"}, {2, "(T0101 CNMG120408)"}, {9, "T0303 (GROOVING TOOL 3 MM)"}}, false);
  ASSERT_TRUE(found.of(1, 5));
  EXPECT_EQ(found.of(1, 5)->line, 2U);
  EXPECT_EQ(found.of(3, 9)->insert.width, 3);
  EXPECT_FALSE(found.of(3, 20));
  EXPECT_FALSE(found.of(2, 5));
}

TEST(InsertProposals, MakesValidTools) {
  const auto made = [](const char* text, const ToolOffset* row = nullptr) {
    return insert_of_comment(read_insert_comment(text, false), 4, row);
  };
  for (const char* const text : {"CNMG120408", "VNMG160404", "RCMT 1204M0", "SNMG120408", "TNMG160404", "РЕЗЕЦ ПРОХОДНОЙ", "BORING BAR D16",
                                 "РЕЗЕЦ КАНАВОЧНЫЙ 3 ММ", "FACE GROOVE TOOL 4 MM", "РЕЗЕЦ РЕЗЬБОВОЙ", "T1 ID THREADING TOOL"}) {
    const auto tool = made(text);
    ASSERT_TRUE(tool) << text;
    EXPECT_EQ(tool_fault_message(*tool), "") << text;
    EXPECT_EQ(tool->kind, ToolKind::turning);
    EXPECT_EQ(tool->number, 4U);
  }
  EXPECT_FALSE(made("GROOVING TOOL"));
  const auto turning = made("CNMG120408"), boring = made("BORING BAR CCMT09T304");
  EXPECT_EQ(turning->insert.tip_x, -1);
  EXPECT_EQ(turning->insert.tip_z, -1);
  EXPECT_EQ(turning->insert.lead, 95);
  EXPECT_EQ(boring->insert.tip_x, 1);
}

TEST(InsertProposals, TheOffsetTableKnowsNoseAndTip) {
  ToolOffset row;
  row.radius = 0.8;
  row.tip_position = 4;
  const auto tool = insert_of_comment(read_insert_comment("VNMG160404", false), 1, &row);
  EXPECT_EQ(tool->corner, 0.8);
  EXPECT_EQ(tool->insert.tip_x, -1);
  EXPECT_EQ(tool->insert.tip_z, 1);
  EXPECT_EQ(tool->angle, 35);
}

}  // namespace
}  // namespace kadr::insert_proposals_test
