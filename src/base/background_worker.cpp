// BackgroundWorker: executes one piece of work at a time in a thread of its own. Used by motion/least_time/planner, session/run_ahead;
// tested by tests/base/background_worker_test.cpp.

#include "base/background_worker.h"

#include <sched.h>

#include <utility>

namespace kadr {

bool has_several_processors() {
  cpu_set_t set;
  return sched_getaffinity(0, sizeof set, &set) == 0 && CPU_COUNT(&set) > 1;
}

BackgroundWorker::~BackgroundWorker() {
  if (!thread_.is_begun()) return;
  finish();
  over_.store(true, std::memory_order_release);
  given_.fetch_add(1, std::memory_order_release);
  given_.notify_one();
  thread_.wait();
}

void BackgroundWorker::execute() {
  try {
    work_();
  } catch (...) {
    failure_ = std::current_exception();
  }
}

void BackgroundWorker::begin(std::function<void()> work) {
  work_ = std::move(work);
  begun_ = true;
  if (!thread_.is_begun() && !alone_) {
    alone_ = !has_several_processors() || !thread_.begin([this] { this->work(); });
  }
  if (alone_) return execute();
  given_.fetch_add(1, std::memory_order_release);
  given_.notify_one();
}

void BackgroundWorker::work() {
  // Number of polls before this thread sleeps. More polls would occupy a processor that other threads need, and no thread waits for the
  // start of the work.
  constexpr int few_polls = 200;
  for (std::uint32_t seen = 0;; ++seen) {
    wait_for(
        given_, [&] { return given_.load(std::memory_order_acquire) != seen; }, few_polls);
    if (over_.load(std::memory_order_acquire)) return;
    if (!claim(seen + 1)) continue;
    execute();
    done_.store(seen + 1, std::memory_order_release);
    done_.notify_one();
  }
}

/// Claims the piece of work with this number. Returns false if the other thread has claimed it already.
bool BackgroundWorker::claim(std::uint32_t number) {
  std::uint32_t before = number - 1;
  return claimed_.compare_exchange_strong(before, number, std::memory_order_acq_rel);
}

/// Finishes the work that was begun: if no processor was free and the thread has not started it yet, executes it in this thread.
void BackgroundWorker::finish() {
  const std::uint32_t given = given_.load(std::memory_order_relaxed);
  if (is_done()) return;
  if (claim(given)) {
    execute();
    done_.store(given, std::memory_order_release);
  } else {
    wait_for(done_, [&] { return is_done(); });
  }
}

void BackgroundWorker::wait() {
  if (!begun_) return;
  if (!alone_) finish();
  begun_ = false;
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

}  // namespace kadr
