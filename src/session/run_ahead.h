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
    // true: the control must know the outcome of each block before it continues, so it executes no blocks in advance
    bool wants_answers = false;
    std::vector<AlarmReport> warnings;
    std::exception_ptr failure;
    bool is_last() const { return state != Control::State::running || wants_answers || failure; }
  };
  /// Returns the control's state after the next batch. The actions and warnings of the batch are swapped with `actions` and `warnings`,
  /// whose memory is reused.
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
  static constexpr std::uint64_t worth_waking = depth / 2;  // the control's thread is woken when at least this many batches are missing

  void work();
  void make();
  template <class Condition>
  void make_or_wait(const Condition& condition);
  bool may_make() const;
  void pass_on_news();

  Control& control_;
  std::array<Batch, depth> ring_;
  Batch* in_work_ = nullptr;  // the batch that is being created; only the thread that runs the control uses this member
  bool going_ = false;        // result of is_going(); only the caller's thread uses this member
  std::uint64_t taken_ = 0;   // number of batches that take() has returned; only the caller's thread uses this member
  Thread thread_;             // started when the first batch is requested
  bool parallel_;             // true: a second processor is available for the thread

  // greatest number of batches, counted from the start, that the control may have created at present
  std::atomic<std::uint64_t> allowed_ = 0;
  std::atomic<std::uint64_t> made_ = 0;
  std::atomic<bool> stands_ = true;         // true: no batch may be created, as the final batch exists or creation has not started
  std::atomic<std::uint32_t> in_hand_ = 0;  // 1: one of the two threads is running the control
  std::atomic<bool> over_ = false;
  // counter of the changes for which the other thread may wait; that thread continues when the counter changes
  std::atomic<std::uint32_t> news_ = 0;
};

}  // namespace kadr
