#include "base/side_by_side.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace kadr::side_by_side_test {
namespace {

TEST(SideBySide, DoesEachPieceOfWorkBeforeItIsWaitedFor) {
  SideBySide beside;
  std::vector<int> done;
  for (int i = 0; i < 300; ++i) {
    EXPECT_FALSE(beside.is_begun());
    beside.begin([&done, i] { done.push_back(i); });
    EXPECT_TRUE(beside.is_begun());
    beside.wait();
    ASSERT_EQ(done.size(), static_cast<std::size_t>(i) + 1);
    ASSERT_EQ(done.back(), i);
  }
}

TEST(SideBySide, WaitsForNothing) {
  SideBySide beside;
  beside.wait();
  EXPECT_FALSE(beside.is_begun());
}

TEST(SideBySide, HandsOnWhatTheWorkThrows) {
  SideBySide beside;
  beside.begin([] { throw std::runtime_error("full"); });
  EXPECT_THROW(beside.wait(), std::runtime_error);
  bool done = false;
  beside.begin([&] { done = true; });
  beside.wait();
  EXPECT_TRUE(done);
}

TEST(SideBySide, EndsWithWorkUnderWay) {
  int done = 0;
  for (int i = 0; i < 200; ++i) {
    SideBySide beside;
    beside.begin([&] { ++done; });
  }
  EXPECT_EQ(done, 200);
}

}  // namespace
}  // namespace kadr::side_by_side_test
