#pragma once
// RunAhead: runs the control in its own thread. The control creates the next batches of actions while path and machine process the last
// batch (docs/architecture.md, "Threads").
//
//   control            creates the batches k+1 · k+2 · … · k+depth, then waits
//   path and machine   process batch k
//
// When the control is queried, it has executed equally much in every run: `depth` batches more than path and machine, or as many as it can.
// On a single processor there is no second thread. Then the caller's thread creates the same batches in advance.

#include <array>
#include <atomic>
#include <exception>
#include <vector>

#include "base/background_worker.h"
#include "control/control.h"

namespace kadr {

class RunAhead {
 public:
  explicit RunAhead(Control& control);
  ~RunAhead();
  RunAhead(const RunAhead&) = delete;
  RunAhead& operator=(const RunAhead&) = delete;

  /// Starts the control, which runs until it needs an answer. From now on the control may be queried only after settle().
  void start();
  /// True while batches are available or can still be created.
  bool is_going() const { return going_; }

  /// A batch of actions, with the warnings during its creation and the control's state after it.
  struct Batch {
    ActionBatch actions;
    Control::State state = Control::State::running;
    bool wants_answers = false;  // true: the control cannot continue until it knows the outcome of each block
    std::vector<AlarmReport> warnings;
    std::exception_ptr failure;
    bool is_last() const { return state != Control::State::running || wants_answers || failure; }
  };
  /// Returns the control's state after the next batch. The actions of the batch are swapped with `actions`, whose memory is reused, and the
  /// warnings with `warnings`.
  Control::State take(ActionBatch& actions, std::vector<AlarmReport>& warnings);
  /// Waits until the control has created as many batches as it may, and has stopped.
  void settle();
  /// Appends to `to`, in order, the batches that take() has not returned yet. The control must have stopped: call settle() first.
  void add_to_come(std::vector<Batch>& to) const;
  /// Drops the batches that take() has not returned yet. To be called before the control is set to another state.
  void forget();
  /// Stores a warning of the control with the batch that is being created. Returns false if no batch is being created.
  bool keep(const AlarmReport& warning);

 private:
  static constexpr std::uint64_t depth = 16;
  static constexpr std::uint64_t worth_waking = depth / 2;  // least number of missing batches for which the thread is woken

  void work();
  void make();
  template <class Condition>
  void make_or_wait(const Condition& condition);
  bool may_make() const;
  void pass_on_news();

  Control& control_;
  std::array<Batch, depth> ring_;
  Batch* in_work_ = nullptr;  // the batch that is being created; only for the thread that runs the control
  bool going_ = false;        // only for the caller's thread
  std::uint64_t taken_ = 0;   // number of batches that take() has returned; only for the caller's thread
  Thread thread_;             // started when the first batch is requested
  bool parallel_;             // true: a second processor is available for the thread

  std::atomic<std::uint64_t> allowed_ = 0;  // number of batches, counted from the start, up to which batches may be created
  std::atomic<std::uint64_t> made_ = 0;
  std::atomic<bool> stands_ = true;         // true: no batch may be created, as the final batch exists or creation has not started
  std::atomic<std::uint32_t> in_hand_ = 0;  // 1: one of the two threads is running the control
  std::atomic<bool> over_ = false;
  std::atomic<std::uint32_t> news_ = 0;  // counter of events; the waiting thread continues when it changes
};

}  // namespace kadr
