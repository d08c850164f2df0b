// session/cutting/turning/stated_blank: the blank of a turned part, from comments and from the path.

#include "session/cutting/turning/stated_blank.h"

#include <gtest/gtest.h>

namespace kadr::stated_blank_test {
namespace {

TEST(StatedBlank, TheFirstDiameterCounts) {
  const auto stated = stated_blank({{1, "O1 (SHAFT)"}, {2, "(BAR D50)"}, {3, "(BAR D60)"}}, false);
  ASSERT_TRUE(stated);
  EXPECT_EQ(*stated->size.diameter, 50);
  EXPECT_EQ(stated->line, 2U);
  EXPECT_EQ(stated->text, "BAR D50");
  EXPECT_FALSE(stated->size.length);
}

TEST(StatedBlank, TheLengthMayBeInACommentOfItsOwn) {
  const auto stated = stated_blank({{1, "(STOCK LENGTH 80)"}, {2, "(STOCK DIAMETER 50)"}}, false);
  ASSERT_TRUE(stated);
  EXPECT_EQ(*stated->size.length, 80);
}

TEST(StatedBlank, NoDiameterIsNoBlank) { EXPECT_FALSE(stated_blank({{1, "(STOCK LENGTH 80)"}, {2, "G1 X50"}}, false)); }

TEST(StatedBlank, BesideThePath) {
  const TurnedExtents path{25.2, -60, 2};
  EXPECT_EQ(turned_blank_text({}, path, 3), "cylinder:0,0,-63,1,52");
  StatedBlank stated;
  stated.size.diameter = 50;
  EXPECT_EQ(turned_blank_text({stated, {}}, path, 3), "cylinder:0,0,-63,1,50");
  stated.size.length = 80;
  EXPECT_EQ(turned_blank_text({stated, {}}, path, 3), "cylinder:0,0,-79,1,50");
  stated.size.bore = 12.7;
  EXPECT_EQ(turned_blank_text({stated, {}}, path, 3), "cylinder:0,0,-79,1,50,12.7");
  EXPECT_EQ(turned_blank_text({{}, -70}, path, 3), "cylinder:0,0,-90,1,52");
  EXPECT_EQ(turned_blank_text({{}, -30}, path, 3), "cylinder:0,0,-63,1,52");
  EXPECT_EQ(turned_blank_text({}, {10, 5, 40}, 3), "cylinder:0,0,2,40,20");
}

}  // namespace
}  // namespace kadr::stated_blank_test
