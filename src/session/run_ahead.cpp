// RunAhead: runs the control in its own thread. The control creates the next batches while path and machine process the last batch
// (docs/architecture.md, "Threads"). RunAhead is used by session/channel_run.

#include "session/run_ahead.h"

#include <utility>

namespace kadr {

RunAhead::RunAhead(Control& control) : control_(control), parallel_(threads_at_once() > 1) {}

RunAhead::~RunAhead() {
  over_.store(true, std::memory_order_release);
  pass_on_news();
  thread_.wait();
}

/// Wakes the other thread, since batches may be created or taken now. On a computer with a single processor there is no other thread, so
/// the missing batches are created here.
void RunAhead::pass_on_news() {
  if (parallel_) {
    news_.fetch_add(1, std::memory_order_release);
    news_.notify_one();
  } else {
    while (may_make()) make();
  }
}

bool RunAhead::may_make() const {
  return !stands_.load(std::memory_order_acquire) && !over_.load(std::memory_order_acquire) &&
         made_.load(std::memory_order_relaxed) < allowed_.load(std::memory_order_acquire);
}

void RunAhead::start() {
  going_ = true;
  allowed_.store(taken_ + depth, std::memory_order_release);
  stands_.store(false, std::memory_order_release);
  if (parallel_ && !thread_.is_begun()) parallel_ = thread_.begin([this] { work(); });
  pass_on_news();
}

void RunAhead::work() {
  while (!over_.load(std::memory_order_acquire)) {
    wait_for(news_, [this] { return may_make() || over_.load(std::memory_order_acquire); });
    while (may_make()) make_or_wait([this] { return may_make(); });
  }
}

/// Creates the next batch, or waits while the other thread runs the control. Either thread may create a batch. So the thread that needs the
/// batch does not wait until the operating system schedules the other thread.
template <class Condition>
void RunAhead::make_or_wait(const Condition& condition) {
  if (in_hand_.exchange(1, std::memory_order_acquire) != 0)
    return wait_for(in_hand_, [this] { return in_hand_.load(std::memory_order_acquire) == 0; });
  if (condition()) make();
  in_hand_.store(0, std::memory_order_release);
  in_hand_.notify_one();
}

void RunAhead::make() {
  const std::uint64_t made = made_.load(std::memory_order_relaxed);
  Batch& batch = ring_[made % depth];
  batch.warnings.clear();
  in_work_ = &batch;
  try {
    batch.state = control_.run(batch.actions);
    batch.wants_answers = control_.returns_each_block();
  } catch (...) {
    batch.failure = std::current_exception();
  }
  in_work_ = nullptr;
  if (batch.is_last()) stands_.store(true, std::memory_order_release);
  made_.store(made + 1, std::memory_order_release);
}

Control::State RunAhead::take(ActionBatch& actions, std::vector<AlarmReport>& warnings) {
  const auto is_missing = [this] { return made_.load(std::memory_order_acquire) <= taken_; };
  while (is_missing()) make_or_wait(is_missing);
  Batch& batch = ring_[taken_ % depth];
  if (batch.failure) std::rethrow_exception(batch.failure);
  std::swap(actions, batch.actions);
  std::swap(warnings, batch.warnings);
  const Control::State state = batch.state;
  going_ = !batch.is_last();
  ++taken_;
  if (going_) {
    allowed_.store(taken_ + depth, std::memory_order_release);
    if (!parallel_ || taken_ + depth >= made_.load(std::memory_order_acquire) + worth_waking) pass_on_news();
  }
  return state;
}

void RunAhead::settle() {
  if (!going_) return;
  while (may_make()) make_or_wait([this] { return may_make(); });
  wait_for(in_hand_, [this] { return in_hand_.load(std::memory_order_acquire) == 0; });
}

void RunAhead::add_to_come(std::vector<Batch>& to) const {
  if (!going_) return;
  for (std::uint64_t k = taken_; k < made_.load(std::memory_order_acquire); ++k) to.push_back(ring_[k % depth]);
}

void RunAhead::forget() {
  settle();
  going_ = false;
  taken_ = made_.load(std::memory_order_acquire);
  allowed_.store(taken_, std::memory_order_release);
  stands_.store(true, std::memory_order_release);
}

bool RunAhead::keep(const AlarmReport& warning) {
  if (in_work_ == nullptr) return false;
  in_work_->warnings.push_back(warning);
  return true;
}

}  // namespace kadr
