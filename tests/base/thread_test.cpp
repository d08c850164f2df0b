#include "base/thread.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace kadr::thread_test {
namespace {

TEST(Thread, HandsOnWhatItsWorkThrows) {
  Thread thread;
  ASSERT_TRUE(thread.begin([] { throw std::runtime_error("full"); }));
  thread.wait();
  EXPECT_THROW(std::rethrow_exception(thread.thrown()), std::runtime_error);
}

TEST(Thread, IsWaitedForWhenItGoes) {
  std::atomic<int> done = 0;
  {
    std::vector<Thread> threads(4);
    for (Thread& thread : threads) ASSERT_TRUE(thread.begin([&] { ++done; }));
  }
  EXPECT_EQ(done, 4);
}

/// A process that may use one processor only begins no threads that would only save time.
TEST(Thread, AreAsManyAsTheProcessMayUse) {
  cpu_set_t before;
  ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
  EXPECT_EQ(threads_at_once(), CPU_COUNT(&before));
  cpu_set_t one;
  CPU_ZERO(&one);
  for (int i = 0; CPU_COUNT(&one) == 0; ++i)
    if (CPU_ISSET(i, &before)) CPU_SET(i, &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(threads_at_once(), 1);
  ASSERT_EQ(sched_setaffinity(0, sizeof before, &before), 0);
}

TEST(SideBySideThreads, DoEachShareOnce) {
  for (const int count : {1, 2, 7, 40}) {
    std::vector<std::atomic<int>> done(static_cast<std::size_t>(count));
    run_parallel(count, [&](int i) { ++done[static_cast<std::size_t>(i)]; });
    for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1);
  }
}

/// The exception may come from any of the threads; all threads have ended by then.
TEST(SideBySideThreads, HandOnWhatOneThrows) {
  for (int bad = 0; bad < 5; ++bad) {
    std::atomic<int> running = 0;
    const auto work = [&](int i) {
      ++running;
      if (i == bad) --running, throw std::runtime_error("full");
      --running;
    };
    EXPECT_THROW(run_parallel(5, work), std::runtime_error);
    EXPECT_EQ(running, 0);
  }
}

}  // namespace
}  // namespace kadr::thread_test
