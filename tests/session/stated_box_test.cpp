// session/cutting/stated_box: the rectangular blank of comments, and where it lies.

#include "session/cutting/stated_box.h"

#include <gtest/gtest.h>

namespace kadr::stated_box_test {
namespace {

BoxComment sized(double x, double y, double z, bool has_axes = false) { return {{x, y, z}, has_axes, {}}; }

void expect_box(const Box3& box, const Box3& wanted) {
  for (int d = 0; d < 3; ++d) {
    EXPECT_NEAR(along(box.least, d), along(wanted.least, d), 1e-9) << d;
    EXPECT_NEAR(along(box.most, d), along(wanted.most, d), 1e-9) << d;
  }
}

TEST(StatedBox, TheFirstCommentWithASizeCounts) {
  const auto stated = stated_box({{1, "O1 (PART)"}, {2, "(PLATE 120X80X25)"}, {3, "(BLANK 1X2X3)"}}, false);
  ASSERT_TRUE(stated);
  EXPECT_EQ(stated->line, 2U);
  EXPECT_EQ(stated->size.size[0], 120);
  EXPECT_EQ(stated->text, "PLATE 120X80X25");
  EXPECT_FALSE(stated_box({{1, "(PART 120X80X25)"}}, false));
}

TEST(StatedBox, AHeadingBeforeTheSizes) {
  const auto stated = stated_box({{1, "(Material Size)"}, {2, "(X= 12.000, Y= 8.000, Z= 0.750)"}}, true);
  ASSERT_TRUE(stated);
  EXPECT_EQ(stated->line, 2U);
  EXPECT_NEAR(stated->size.size[2], 19.05, 1e-9);
  EXPECT_FALSE(stated_box({{1, "(Material Size)"}, {2, "(X=)"}, {3, "(X= 12.0, Y= 8.0, Z= 0.75)"}}, true));
}

TEST(StatedBox, TheBlankOfAConversationalProgram) {
  const auto stated = stated_box(
      {{1, "0 BEGIN PGM T MM"}, {2, "1 BLK FORM 0.1 Z X-10 Y+0 Z-20 ; (PLATE 1X2X3)"}, {3, "2 BLK FORM 0.2 X+90 Y+60 Z+0"}}, false);
  ASSERT_TRUE(stated);
  EXPECT_EQ(stated->line, 3U);
  expect_box(placed_box(stated->size, {{500, 500, -5}, {510, 510, 0}}, 0), {{-10, 0, -20}, {90, 60, 0}});
  const auto inch = stated_box({{1, "BEGIN PGM T INCH"}, {2, "BLK FORM 0.1 Z X0 Y0 Z-1"}, {3, "BLK FORM 0.2 IX+2 IY+1 IZ+1"}}, false);
  ASSERT_TRUE(inch);
  expect_box(placed_box(inch->size, {{0, 0, 0}, {1, 1, 1}}, 0), {{0, 0, -25.4}, {50.8, 25.4, 0}});
  for (const char* const second :
       {"BLK FORM 0.2 X+Q1 Y+60 Z+0", "BLK FORM 0.2 X+90 Y+60", "BLK FORM 0.2 X-10 Y+60 Z+0", "; BLK FORM 0.2 X1 Y1 Z1"})
    EXPECT_FALSE(stated_box({{1, "BLK FORM 0.1 Z X-10 Y+0 Z-20"}, {2, second}}, false)) << second;
}

TEST(StatedBox, LiesWhereItHoldsTheCut) {
  expect_box(placed_box(sized(120, 80, 25), {{-50, -30, -5}, {50, 30, 0}}, 0), {{-60, -40, -25}, {60, 40, 0}});
  expect_box(placed_box(sized(120, 80, 25), {{10, 10, -5}, {110, 70, 0}}, 0), {{0, 0, -25}, {120, 80, 0}});
  expect_box(placed_box(sized(120, 80, 25), {{-110, 10, -5}, {-10, 70, 0}}, 0), {{-120, 0, -25}, {0, 80, 0}});
  expect_box(placed_box(sized(120, 80, 25), {{-65, -45, -25}, {65, 45, 0}}, 0), {{-60, -40, -25}, {60, 40, 0}});  // a contour around it
  expect_box(placed_box(sized(120, 80, 25), {{300, 200, -5}, {400, 260, 0}}, 0), {{290, 190, -25}, {410, 270, 0}});
}

TEST(StatedBox, StandsOnTheTableIfItsZeroIsThere) {
  expect_box(placed_box(sized(120, 80, 25), {{10, 10, 20}, {110, 70, 25}}, 25), {{0, 0, 0}, {120, 80, 25}});
  expect_box(placed_box(sized(120, 80, 25), {{10, 10, -5}, {110, 70, 2}}, 0), {{0, 0, -25}, {120, 80, 0}});
}

TEST(StatedBox, AnotherOrderOfTheSizesWhereOnlyThatFits) {
  expect_box(placed_box(sized(25, 80, 120), {{-50, -30, -5}, {50, 30, 0}}, 0), {{-60, -40, -25}, {60, 40, 0}});
  expect_box(placed_box(sized(80, 120, 25), {{-50, -30, -5}, {50, 30, 0}}, 0), {{-60, -40, -25}, {60, 40, 0}});
  expect_box(placed_box(sized(80, 120, 25, true), {{-50, -30, -5}, {50, 30, 0}}, 0), {{-40, -60, -25}, {40, 60, 0}});
}

TEST(StatedBox, AStatedZeroDecides) {
  BoxComment stated = sized(100, 80, 20, true);
  stated.zero = {0, 0, 20};
  expect_box(placed_box(stated, {{-50, -30, -5}, {50, 30, 0}}, 0), {{0, 0, -20}, {100, 80, 0}});
}

}  // namespace
}  // namespace kadr::stated_box_test
