#pragma once
// PanelSearch: finds places in a machine's program, in its own thread in parallel with the machine: what is in force there, and the whole
// state of the control. It first runs through the whole program with checkpoints; then any line of a long program is found quickly.
//
//   begin(start) ──▶ first pass ──▶ find(request): not ready … a place, or why there is none

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

/// State of another channel then: between two of its blocks, as far as the control has run by its clock (session/channels).
struct PanelBeside {
  std::size_t channel = 0;  // its index
  int number = 1;
  Restart restart;  // `at`: its next block, or the current one
  AlarmReport::Line line;
  std::vector<AlarmReport::Call> calls;
  Placement placement;
  std::optional<Control::Meeting> waits;  // set at a waiting code
  bool in_block = false;
  bool is_over = false;      // its program has ended
  std::uint64_t blocks = 0;  // number of blocks executed
};

/// A place where the program could continue.
struct PanelPlace {
  Restart restart;
  AlarmReport::Line line;
  std::vector<AlarmReport::Call> calls;
  Placement placement;                    // of the work coordinate system
  Stepping::Memory memory;                // state of a control that has run to here
  bool in_block = false;                  // over a hole of a canned cycle
  std::optional<BlockSearch> by_control;  // result of the control's own block search, if it has one
  std::vector<PanelBeside> beside;        // the other channels
};

class PanelSearch {
 public:
  struct Wish {
    StopPoint target;
    std::uint32_t hole = 0;               // of a canned cycle: the place over this hole; 0: before the block
    bool by_control = false;              // use the control's own block search too: another run through the whole program
    std::vector<std::uint64_t> blocks{};  // executed by each channel then, by index; empty: by the clock of the own channel
    friend bool operator==(const Wish&, const Wish&) = default;
  };
  struct Answer {
    bool ready = false;
    std::shared_ptr<const PanelPlace> place{};  // nullptr if ready: there is no such place
    std::string error{};                        // why there is none
  };

  explicit PanelSearch(PanelOpens opens);
  ~PanelSearch();
  PanelSearch(const PanelSearch&) = delete;  // its thread uses this object
  PanelSearch& operator=(const PanelSearch&) = delete;

  /// Replaces the run in which places are searched.
  void begin(const PanelStart& start);
  /// Returns immediately with what is known now. A request other than the previous one starts a new search.
  Answer find(const Wish& wish);

 private:
  /// Everything that belongs to one run.
  struct Run {
    std::unique_ptr<Session> session;
    std::unique_ptr<Checkpoints> checkpoints;
    std::unique_ptr<Stepping> stepping;
    std::string error;  // set if it could not be opened
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
  // used by its thread only
  Run run_;
  PanelStart start_;
  bool own_is_over_ = false;  // with several channels: the own channel's program has ended
  std::atomic<bool> stops_{false};

  std::mutex lock_;
  std::condition_variable wakes_;
  bool ends_ = false;
  std::optional<PanelStart> to_begin_;
  std::optional<Wish> wish_;
  Lang lang_{};
  bool searching_ = false;
  std::optional<Answer> answer_;  // the answer to wish_
  Thread thread_;
};

}  // namespace kadr
