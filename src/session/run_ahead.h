#pragma once
// RunAhead: the control interprets the next batches in a thread of its own while the rooms after it take the last one (design.md 1).
//
//   control    batch k+1 · k+2 · … · k+depth, then it waits
//   after it   batch k
//
// How far the control has come when it is asked for something is the same in every run: `depth` batches, or as far as it can go. Where
// there is one processor only, it goes as far at once.

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

  /// The control begins: until it must be answered. From here on it may be asked after settle() only.
  void start();
  /// Batches are there, or are to come.
  bool is_going() const { return going_; }

  /// What is said of a batch.
  struct Batch {
    ActionBatch actions;
    Control::State state = Control::State::running;
    bool wants_answers = false;  // from here on the control wants to know what becomes of each block
    std::vector<AlarmReport> warnings;
    std::exception_ptr failure;
    bool is_last() const { return state != Control::State::running || wants_answers || failure; }
  };
  /// The next batch: its actions in exchange for used ones, its warnings.
  Control::State take(ActionBatch& actions, std::vector<AlarmReport>& warnings);
  /// The control stands still, as far ahead as it goes.
  void settle();
  /// The batches made and not taken yet, in order; it stands still.
  void add_to_come(std::vector<Batch>& to) const;
  /// The control is somewhere else: these are not to come any more.
  void forget();
  /// A warning of the control: kept until its batch is taken. False: it is not under way.
  bool keep(const AlarmReport& warning);

 private:
  static constexpr std::uint64_t depth = 16;
  static constexpr std::uint64_t worth_waking = depth / 2;  // batches to be made: for fewer the thread is left asleep

  void work();
  void make();
  template <class Wanted>
  void make_or_wait(const Wanted& wanted);
  bool may_make() const;
  void give_way();

  Control& control_;
  std::array<Batch, depth> ring_;
  Batch* in_work_ = nullptr;  // of the thread that runs the control
  bool going_ = false;        // this side's own
  std::uint64_t taken_ = 0;   //
  Thread thread_;             // begun with the first batch
  bool beside_;               // there is a processor for the thread

  std::atomic<std::uint64_t> allowed_ = 0;  // batches that may be made in all
  std::atomic<std::uint64_t> made_ = 0;
  std::atomic<bool> stands_ = true;         // the last batch made is the last
  std::atomic<std::uint32_t> in_hand_ = 0;  // 1: one of the two sides runs the control
  std::atomic<bool> over_ = false;
  std::atomic<std::uint32_t> news_ = 0;  // counts what the thread may wait for
};

}  // namespace kadr
