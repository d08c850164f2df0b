// session/tool_proposals: which comment describes which tool, and the unit of its sizes.

#include "session/tool_proposals.h"

#include <gtest/gtest.h>

#include "a_session.h"

namespace kadr::tool_proposals_test {
namespace {

/// Returns true if the comments of this program are in inches.
bool in_inches(const std::string& control, const std::string& program) {
  test::ASession session(control, program);
  EXPECT_TRUE(session.opened());
  MotionUnits moved;
  session->outlets().programmed = [&](const Action& action) {
    if (const auto* const motion = std::get_if<Motion>(&action.what)) moved.take(*motion);
  };
  (void)session->run();
  return comments_in_inches(session->control(), moved);
}

TEST(ToolProposals, TheUnitOfTheBlocksThatCut) {
  for (const char* control : {"fanuc", "haas", "mach3", "linuxcnc", "nct"}) {
    EXPECT_TRUE(in_inches(control, "G20\nG90\nG1 X1. F10.\nM30\n")) << control << ": M30 may reset to millimetres";
    EXPECT_FALSE(in_inches(control, "G21\nG90\nG1 X1. F100.\nM30\n")) << control;
    EXPECT_TRUE(in_inches(control, "G21\nG0 X1.\nG20\nG90\nG1 X1. F10.\nG21\nG0 X0\nM30\n")) << control << ": it cuts in inches";
    EXPECT_FALSE(in_inches(control, "G20\nG0 X1.\nG21\nG90\nG1 X1. F100.\nG20\nM30\n")) << control << ": it cuts in millimetres";
    EXPECT_FALSE(in_inches(control, "G20\nG90\nG1 X1. F10.\nG21\nG1 X2. F100.\nM30\n")) << control << ": in both: nobody knows";
  }
}

TEST(ToolProposals, TheUnitOfAProgramWithoutAMotion) {
  EXPECT_TRUE(in_inches("mach3", "G20\nT1 M6\n"));
  EXPECT_TRUE(in_inches("mach3", "G70\nT1 M6\n"));
  EXPECT_FALSE(in_inches("mach3", "T1 M6\n"));
}

TEST(ToolProposals, TheCommentThatNamesTheToolThenTheOneBeside) {
  const ProgramLines lines = {{1, "(T1 D10 ENDMILL)"}, {2, "T1 M6 (DRILL 5.5)"},   {4, "(6.8MM DRILL)"}, {5, "T2 M6"}, {8, "T3 M6"},
                              {9, "(T4 8MM REAMER)"},  {10, "(D16 ENDMILL) (D2)"}, {11, "T5 M6"}};
  const ToolProposals comments(lines, false);
  EXPECT_EQ(comments.of(1, 2)->line, 1U);
  EXPECT_EQ(comments.of(1, 2)->tool_data.diameter, 10);
  EXPECT_EQ(comments.of(2, 5)->tool_data.diameter, 6.8);
  EXPECT_FALSE(comments.of(2, 0)) << "it is called in another file";
  EXPECT_FALSE(comments.of(3, 8)) << "the comment beside names another tool";
  EXPECT_EQ(comments.of(5, 11)->text, "D16 ENDMILL");
}

TEST(ToolProposals, TheCommentThatIsNotSure) {
  const ProgramLines lines = {{1, "(T1 6. FLAT ENDMILL)"}, {2, "T1 M6"}, {3, "(SPOT DRILL)"}, {4, "T2 M6"},
                              {6, "(.5 ENDMILL)"},         {7, "T3 M6"}};
  const ToolProposals comments(lines, true);
  EXPECT_FALSE(comments.of(1, 2));
  EXPECT_EQ(comments.unsure(1, 2)->text, "T1 6. FLAT ENDMILL");
  EXPECT_EQ(comments.unsure(2, 4)->line, 3U);
  EXPECT_EQ(comments.of(3, 7)->tool_data.diameter, 12.7);
  EXPECT_FALSE(comments.unsure(3, 7));
}

}  // namespace
}  // namespace kadr::tool_proposals_test
