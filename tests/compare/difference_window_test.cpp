// compare/difference_window: which area is shown close up, and from which side.

#include "compare/difference_window.h"

#include <gtest/gtest.h>

namespace kadr::difference_window_test {
namespace {

const Box part{{0, 0, -10}, {300, 200, 50}, false};

TEST(DifferenceWindow, ALittleOfALongWay) {
  const Box differing{{0, 100, -1}, {300.02, 102, -1}, false};
  const DifferenceWindow w = window_of(differing, {0.02, 0, 0}, {300.02, 100, -1}, part);
  EXPECT_EQ(w.view, View::xy);
  EXPECT_TRUE(w.closer);
  const double size = w.box.most.x - w.box.least.x;
  EXPECT_GT(size, 0.02 * 4);
  EXPECT_LT(size, 0.02 * 12);
  EXPECT_NEAR((w.box.most.x + w.box.least.x) / 2, 300.01, 1e-9);
}

TEST(DifferenceWindow, AllOfASmallOne) {
  const DifferenceWindow w = window_of({{10, 10, 0}, {14, 12, 0}, false}, {0, 1, 0}, {12, 12, 0}, part);
  EXPECT_LE(w.box.least.x, 10);
  EXPECT_GE(w.box.most.x, 14);
  EXPECT_LT(w.box.most.x - w.box.least.x, 8);
}

TEST(DifferenceWindow, FromTheSideThatShowsIt) {
  EXPECT_EQ(window_of({{0, 5, -1}, {10, 5, 0}, false}, {0, 0, 0.01}, {5, 5, -1}, part).view, View::xz);
  EXPECT_EQ(window_of({{5, 0, -1}, {5, 10, 0}, false}, {0, 0, 0.01}, {5, 5, -1}, part).view, View::yz);
  EXPECT_EQ(window_of({{0, 0, -1}, {10, 10, -1}, false}, {0.01, 0.01, 0}, {5, 5, -1}, part).view, View::xy);
}

TEST(DifferenceWindow, APlaceHasSurroundings) {
  const DifferenceWindow w = window_of({{5, 5, 0}, {5, 5, 0}, false}, {}, {}, part);
  EXPECT_GT(w.box.most.x - w.box.least.x, 10);
  EXPECT_TRUE(w.closer);
  EXPECT_FALSE(window_of(part, {}, {}, part).closer);
}

TEST(DifferenceWindow, NeverNothing) {
  const DifferenceWindow w = window_of({{0, 0, 0}, {0, 0, 0}, false}, {1e-9, 0, 0}, {}, {{0, 0, 0}, {0, 0, 0}, false});
  EXPECT_GT(w.box.most.x - w.box.least.x, 0.01);
}

}  // namespace
}  // namespace kadr::difference_window_test
