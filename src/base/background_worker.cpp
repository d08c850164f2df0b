// BackgroundWorker: executes one task at a time in a thread of its own. Used by motion/least_time/planner, session/run_ahead; tested by
// tests/base/background_worker_test.cpp.

#include "base/background_worker.h"

#include <utility>

namespace kadr {

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
    alone_ = threads_at_once() == 1 || !thread_.begin([this] { this->work(); });
  }
  if (alone_) return execute();
  given_.fetch_add(1, std::memory_order_release);
  given_.notify_one();
}

void BackgroundWorker::work() {
  // Number of polls before the worker thread sleeps. With more polls, the worker would occupy a processor that other threads need, while no
  // thread waits for the task to start.
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

/// Claims the task with this number for the calling thread. Returns false if the other thread has claimed the task already.
bool BackgroundWorker::claim(std::uint32_t number) {
  std::uint32_t before = number - 1;
  return claimed_.compare_exchange_strong(before, number, std::memory_order_acq_rel);
}

/// Waits until the task that was begun is done. If the worker thread has not claimed the task yet, executes it in the calling thread.
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
