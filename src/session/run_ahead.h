#pragma once
// RunAhead: the control interprets the next batches in its own thread while the rooms after it process the last one (docs/architecture.md,
// "Threads").
//
//   control    batch k+1 · k+2 · … · k+depth, then it waits
//   after it   batch k
//
// How far ahead the control is when it is queried is the same in every run: `depth` batches, or as far as it can go. With a single
// processor there is no thread: the control always runs that far ahead at once.

#include <array>
#include <atomic>
#include <exception>
#include <vector>

#include "base/side_by_side.h"
#include "control/control.h"

namespace kadr {

class RunAhead {
 public:
  explicit RunAhead(Control& control);
  ~RunAhead();
  RunAhead(const RunAhead&) = delete;
  RunAhead& operator=(const RunAhead&) = delete;

  /// Starts the control: it runs until it needs an answer. From here on it may be queried only after settle().
  void start();
  /// True while batches are ready or still to come.
  bool is_going() const { return going_; }

  /// A batch with the data that belongs to it.
  struct Batch {
    ActionBatch actions;
    Control::State state = Control::State::running;
    bool wants_answers = false;  // from here on the control needs the outcome of each block
    std::vector<AlarmReport> warnings;
    std::exception_ptr failure;
    bool is_last() const { return state != Control::State::running || wants_answers || failure; }
  };
  /// Takes the next batch: exchanges its actions for used ones, and gives its warnings.
  Control::State take(ActionBatch& actions, std::vector<AlarmReport>& warnings);
  /// Waits until the control has stopped, as far ahead as it may go.
  void settle();
  /// Appends the batches that are created and not taken yet, in order. The control must be stopped (settle()).
  void add_to_come(std::vector<Batch>& to) const;
  /// Drops the batches that are created and not taken: the control has been set to another position.
  void forget();
  /// Keeps a warning of the control until its batch is taken. Returns false if the control is not running ahead.
  bool keep(const AlarmReport& warning);

 private:
  static constexpr std::uint64_t depth = 16;
  static constexpr std::uint64_t worth_waking = depth / 2;  // batches to create; for fewer the thread is not woken

  void work();
  void make();
  template <class Wanted>
  void make_or_wait(const Wanted& wanted);
  bool may_make() const;
  void give_way();

  Control& control_;
  std::array<Batch, depth> ring_;
  Batch* in_work_ = nullptr;  // the batch being created, of the thread that runs the control
  bool going_ = false;        // used by the caller's thread only
  std::uint64_t taken_ = 0;   // likewise
  Thread thread_;             // started with the first batch
  bool beside_;               // there is a processor for the thread

  std::atomic<std::uint64_t> allowed_ = 0;  // total number of batches that may be created
  std::atomic<std::uint64_t> made_ = 0;
  std::atomic<bool> stands_ = true;         // the last batch created was the final one
  std::atomic<std::uint32_t> in_hand_ = 0;  // 1: one of the two threads runs the control
  std::atomic<bool> over_ = false;
  std::atomic<std::uint32_t> news_ = 0;  // counter that the thread waits on
};

}  // namespace kadr
