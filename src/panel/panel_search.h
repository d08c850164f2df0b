#pragma once
// PanelSearch: finds places of a machine's program, in a thread of its own, beside the machine: what is in force there, and all that the
// control remembers. Once through the whole program with checkpoints; then any line of a long one is there at once.
//
//   begin(start) ──▶ first pass ──▶ find(wish): not ready … a place, or why there is none

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>

#include "base/thread.h"
#include "config/alarm_texts.h"
#include "panel/panel_opens.h"
#include "session/block_search.h"
#include "session/checkpoints.h"
#include "session/restart.h"

namespace kadr {

/// Where one of the other channels stands then: between two of its blocks, as the control has come to them by its clock (session/channels).
struct PanelBeside {
  std::size_t channel = 0;  // its index
  int number = 1;
  Restart restart;  // `at`: its block that comes next, or is under way
  AlarmReport::Line line;
  std::vector<AlarmReport::Call> calls;
  Placement placement;
  std::optional<Control::Meeting> waits;  // at a waiting code
  bool in_block = false;
  bool is_over = false;      // its program
  std::uint64_t blocks = 0;  // carried out
};

/// A place where the program could go on.
struct PanelPlace {
  Restart restart;
  AlarmReport::Line line;
  std::vector<AlarmReport::Call> calls;
  Placement placement;                    // of the work coordinates
  Stepping::Memory memory;                // of a control that has come there
  bool in_block = false;                  // over a hole of a cycle
  std::optional<BlockSearch> by_control;  // its own block search, where it has one
  std::vector<PanelBeside> beside;        // the other channels
};

class PanelSearch {
 public:
  struct Wish {
    StopPoint target;
    std::uint32_t hole = 0;               // of a cycle: over that one; 0: before the block
    bool by_control = false;              // its own block search too: once more through the whole program
    std::vector<std::uint64_t> blocks{};  // that each channel has carried out then, by its index; empty: by the clock of the own one
    friend bool operator==(const Wish&, const Wish&) = default;
  };
  struct Answer {
    bool ready = false;
    std::shared_ptr<const PanelPlace> place{};  // nullptr, where it is ready: there is none
    std::string error{};                        // why
  };

  explicit PanelSearch(PanelOpens opens);
  ~PanelSearch();
  PanelSearch(const PanelSearch&) = delete;  // its thread looks at it
  PanelSearch& operator=(const PanelSearch&) = delete;

  /// The run that places are asked of is another one.
  void begin(const PanelStart& start);
  /// At once: what is known of it now. A wish other than the one before begins a new search.
  Answer find(const Wish& wish);

 private:
  /// Of one run.
  struct Run {
    std::unique_ptr<Session> session;
    std::unique_ptr<Checkpoints> checkpoints;
    std::unique_ptr<Stepping> stepping;
    std::string error;  // it could not be opened
    bool is_there = false;
  };

  void live();
  void forget();
  void prepare(const PanelStart& start);
  Answer search(const Wish& wish);
  void end_with_own(Control& other);
  void run_apart(const Wish& wish);
  Answer found(const Wish& wish);
  std::optional<Restart> reach(const Wish& wish);
  std::vector<PanelBeside> beside();
  void find_next(PanelBeside& channel);
  std::optional<BlockSearch> search_by_control(const StopPoint& target);
  std::unique_ptr<Session> open();

  const PanelOpens opens_;
  // of its thread
  Run run_;
  PanelStart start_;
  bool own_is_over_ = false;  // the program of the own channel, of several
  std::atomic<bool> stops_{false};

  std::mutex lock_;
  std::condition_variable wakes_;
  bool ends_ = false;
  std::optional<PanelStart> to_begin_;
  std::optional<Wish> wish_;
  Lang lang_{};
  bool searching_ = false;
  std::optional<Answer> answer_;  // to wish_
  Thread thread_;
};

}  // namespace kadr
