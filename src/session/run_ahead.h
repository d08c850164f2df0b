#pragma once
// RunAhead: runs the control in its own thread, so that it interprets the next batches of actions while path and machine process the last
// one (docs/architecture.md, "Threads").
//
//   control            batch k+1 · k+2 · … · k+depth, then it waits
//   path and machine   batch k
//
// When the control is queried, it is equally far ahead in every run: `depth` batches, or as far as it can go. On a single processor there
// is no thread; the caller's thread runs the control equally far ahead.

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
  /// True while batches are ready or still to be created.
  bool is_going() const { return going_; }

  /// A batch of actions, with its warnings and the state of the control after it.
  struct Batch {
    ActionBatch actions;
    Control::State state = Control::State::running;
    bool wants_answers = false;  // after this batch the control needs the outcome of each block
    std::vector<AlarmReport> warnings;
    std::exception_ptr failure;
    bool is_last() const { return state != Control::State::running || wants_answers || failure; }
  };
  /// Returns the next batch: swaps its actions with `actions`, whose memory is used again, and moves its warnings to `warnings`.
  Control::State take(ActionBatch& actions, std::vector<AlarmReport>& warnings);
  /// Waits until the control's thread has stopped, as far ahead as it may run.
  void settle();
  /// Appends to `to` the batches that are created and not taken yet, in order. The control must be stopped (settle()).
  void add_to_come(std::vector<Batch>& to) const;
  /// Drops the batches that are created and not taken yet. Called when the control has been set to another position.
  void forget();
  /// Stores a warning of the control until its batch is taken. Returns false if the control is not running ahead.
  bool keep(const AlarmReport& warning);

 private:
  static constexpr std::uint64_t depth = 16;
  static constexpr std::uint64_t worth_waking = depth / 2;  // the thread is woken when at least this many batches are to be created

  void work();
  void make();
  template <class Wanted>
  void make_or_wait(const Wanted& wanted);
  bool may_make() const;
  void give_way();

  Control& control_;
  std::array<Batch, depth> ring_;
  Batch* in_work_ = nullptr;  // the batch being created; used by the thread that runs the control
  bool going_ = false;        // used by the caller's thread only
  std::uint64_t taken_ = 0;   // number of batches taken; used by the caller's thread only
  Thread thread_;             // started with the first batch
  bool beside_;               // there is a second processor, for the thread

  std::atomic<std::uint64_t> allowed_ = 0;  // total number of batches that may be created so far
  std::atomic<std::uint64_t> made_ = 0;
  std::atomic<bool> stands_ = true;         // true: the final batch has been created, or creation has not started
  std::atomic<std::uint32_t> in_hand_ = 0;  // 1: one of the two threads is running the control
  std::atomic<bool> over_ = false;
  std::atomic<std::uint32_t> news_ = 0;  // counter on whose change the waiting thread continues
};

}  // namespace kadr
