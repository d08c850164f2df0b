#pragma once
// PanelSearch: finds restart positions in the program of a panel machine, and the state of the control there. It has its own thread, in
// parallel with the machine. First it runs through the whole program and stores checkpoints; from these, any line of a long program is
// found quickly.
//
//   begin(start) ──▶ first run ──▶ find(request): not ready … a restart position, or the reason why there is none

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>

#include "base/thread.h"
#include "config/alarm_texts.h"
#include "panel/session_opener.h"
#include "session/block_search.h"
#include "session/checkpoints.h"
#include "session/restart.h"

namespace kadr {

/// State of another channel when the program's own channel is at the restart position. As far as its virtual time allows
/// (session/channels), the other channel is then between two blocks.
struct OtherChannelState {
  std::size_t channel = 0;  // index of the channel
  int number = 1;
  Restart restart;  // restart.at: the channel's next block, or the block that it is executing
  AlarmReport::Line line;
  std::vector<AlarmReport::Call> calls;
  Placement placement;
  std::optional<Control::Meeting> waits;  // the meeting at which the channel waits; nullopt: it does not wait
  bool in_block = false;
  bool is_over = false;      // the program of the channel has ended
  std::uint64_t blocks = 0;  // number of blocks that the channel has executed
};

/// A position where the program could continue.
struct RestartPoint {
  Restart restart;
  AlarmReport::Line line;
  std::vector<AlarmReport::Call> calls;
  Placement placement;                    // position of the work coordinate system
  Stepping::Memory memory;                // snapshot of the run when its control has reached this position
  bool in_block = false;                  // the position is over a drilled hole of a canned cycle
  std::optional<BlockSearch> by_control;  // result of the control's own block search; nullopt if it has none
  std::vector<OtherChannelState> beside;  // states of the other channels at that moment
};

class PanelSearch {
 public:
  struct SearchRequest {
    StopPoint target;
    std::uint32_t hole = 0;   // number of a drilled hole of a canned cycle over which to continue; 0: before the block
    bool by_control = false;  // also execute the control's own block search, which needs one more run through the program
    // Number of blocks that each channel must have executed, by index. Empty: the other channels are where the virtual time of the own
    // channel puts them.
    std::vector<std::uint64_t> blocks{};
    friend bool operator==(const SearchRequest&, const SearchRequest&) = default;
  };
  struct Answer {
    bool ready = false;
    std::shared_ptr<const RestartPoint> place{};  // nullptr although `ready` is true: no restart position matches the request
    std::string error{};                          // why there is no restart position
  };

  explicit PanelSearch(SessionOpener opens);
  ~PanelSearch();
  PanelSearch(const PanelSearch&) = delete;  // the search thread uses this object
  PanelSearch& operator=(const PanelSearch&) = delete;

  /// Discards all results, and starts searching in a run with this start position and these switches.
  void begin(const PanelStart& start);
  /// Returns at once what is known about the request so far. A request that differs from the previous one starts a new search.
  Answer find(const SearchRequest& request);

 private:
  /// The session that the search uses, and the data that refer to it.
  struct Run {
    std::unique_ptr<Session> session;
    std::unique_ptr<Checkpoints> checkpoints;
    std::unique_ptr<Stepping> stepping;
    std::string error;  // why the session could not be opened; empty: it is open
    bool is_there = false;
  };

  void live();
  void forget();
  void prepare(const PanelStart& start);
  Answer search(const SearchRequest& request);
  void end_with_own(Control& other);
  void run_each_channel(const SearchRequest& request);
  Answer found(const SearchRequest& request);
  std::optional<Restart> reach(const SearchRequest& request);
  std::vector<OtherChannelState> beside();
  void find_next(OtherChannelState& channel);
  std::optional<BlockSearch> search_by_control(const StopPoint& target);
  std::unique_ptr<Session> open();

  const SessionOpener opens_;
  // The members below are used by the search thread only.
  Run run_;
  PanelStart start_;
  bool own_is_over_ = false;  // on a machine with several channels: the own channel's program has ended
  std::atomic<bool> stops_{false};

  std::mutex lock_;
  std::condition_variable wakes_;
  bool ends_ = false;
  std::optional<PanelStart> to_begin_;
  std::optional<SearchRequest> request_;
  Lang lang_{};
  bool searching_ = false;
  std::optional<Answer> answer_;  // the answer to request_; nullopt: not found yet
  Thread thread_;
};

}  // namespace kadr
