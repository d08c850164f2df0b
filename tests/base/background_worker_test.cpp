#include "base/background_worker.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace kadr::background_worker_test {
namespace {

TEST(BackgroundWorker, DoesEachPieceOfWorkBeforeItIsWaitedFor) {
  BackgroundWorker beside;
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

TEST(BackgroundWorker, WaitsForNothing) {
  BackgroundWorker beside;
  beside.wait();
  EXPECT_FALSE(beside.is_begun());
}

TEST(BackgroundWorker, HandsOnWhatTheWorkThrows) {
  BackgroundWorker beside;
  beside.begin([] { throw std::runtime_error("full"); });
  EXPECT_THROW(beside.wait(), std::runtime_error);
  bool done = false;
  beside.begin([&] { done = true; });
  beside.wait();
  EXPECT_TRUE(done);
}

TEST(BackgroundWorker, EndsWithWorkUnderWay) {
  int done = 0;
  for (int i = 0; i < 200; ++i) {
    BackgroundWorker beside;
    beside.begin([&] { ++done; });
  }
  EXPECT_EQ(done, 200);
}

}  // namespace
}  // namespace kadr::background_worker_test
