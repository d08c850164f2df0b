// session/cutting/window_touches: inside the window its own collisions replace those of the whole, and none is reported twice.

#include "session/cutting/window_touches.h"

#include <gtest/gtest.h>

namespace kadr::window_touches_test {
namespace {

const Box3 window{{0, 0, -10}, {10, 10, 0}};

Touch touch(std::uint32_t sweep, ToolPart part, double from, double to, double volume) {
  return {sweep, part, {{from, 1, -2}, {to, 2, -1}}, volume};
}

TEST(finer_touches, inside_the_window_its_own_count) {
  const auto all = finer_touches(window, {touch(3, ToolPart::holder, 2, 4, 7)}, {touch(3, ToolPart::holder, 2.1, 3.9, 6.5)});
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].volume, 6.5);
  EXPECT_EQ(all[0].around.least.x, 2.1);
}

TEST(finer_touches, what_only_the_whole_sees_inside_is_none) {
  EXPECT_TRUE(finer_touches(window, {touch(3, ToolPart::holder, 2, 4, 7)}, {}).empty());
  EXPECT_TRUE(finer_touches(window, {}, {}).empty());
}

TEST(finer_touches, beyond_the_window_the_whole_counts) {
  const auto all = finer_touches(window, {touch(3, ToolPart::cutting, 12, 14, 7)}, {});
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].volume, 7);
}

TEST(finer_touches, through_a_face_it_is_one) {
  const auto all = finer_touches(window, {touch(3, ToolPart::cutting, 8.2, 14, 7)}, {touch(3, ToolPart::cutting, 8.05, 10, 2.4)});
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].volume, 7);
  EXPECT_EQ(all[0].around.least.x, 8.05);
  EXPECT_EQ(all[0].around.most.x, 14);
}

TEST(finer_touches, in_the_order_of_sweeps_and_parts) {
  const auto all = finer_touches(
      window, {touch(1, ToolPart::shank, 12, 13, 1), touch(4, ToolPart::cutting, 12, 13, 1), touch(6, ToolPart::holder, 9, 13, 1)},
      {touch(1, ToolPart::cutting, 1, 2, 1), touch(5, ToolPart::cutting, 1, 2, 1), touch(6, ToolPart::shank, 1, 2, 1)});
  ASSERT_EQ(all.size(), 6U);
  const std::uint32_t sweeps[] = {1, 1, 4, 5, 6, 6};
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].sweep, sweeps[i]);
  EXPECT_EQ(all[0].part, ToolPart::cutting);
  EXPECT_EQ(all[5].part, ToolPart::holder);
}

}  // namespace
}  // namespace kadr::window_touches_test
