#include "base/background_worker.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace kadr::background_worker_test {
namespace {

TEST(BackgroundWorker, DoesEachPieceOfWorkBeforeItIsWaitedFor) {
  BackgroundWorker worker;
  std::vector<int> done;
  for (int i = 0; i < 300; ++i) {
    EXPECT_FALSE(worker.is_begun());
    worker.begin([&done, i] { done.push_back(i); });
    EXPECT_TRUE(worker.is_begun());
    worker.wait();
    ASSERT_EQ(done.size(), static_cast<std::size_t>(i) + 1);
    ASSERT_EQ(done.back(), i);
  }
}

TEST(BackgroundWorker, WaitsForNothing) {
  BackgroundWorker worker;
  worker.wait();
  EXPECT_FALSE(worker.is_begun());
}

TEST(BackgroundWorker, HandsOnWhatTheWorkThrows) {
  BackgroundWorker worker;
  worker.begin([] { throw std::runtime_error("full"); });
  EXPECT_THROW(worker.wait(), std::runtime_error);
  bool done = false;
  worker.begin([&] { done = true; });
  worker.wait();
  EXPECT_TRUE(done);
}

TEST(BackgroundWorker, EndsWithWorkUnderWay) {
  int done = 0;
  for (int i = 0; i < 200; ++i) {
    BackgroundWorker worker;
    worker.begin([&] { ++done; });
  }
  EXPECT_EQ(done, 200);
}

}  // namespace
}  // namespace kadr::background_worker_test
