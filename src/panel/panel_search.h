#pragma once
// PanelSearch finds restart positions in the program of a panel machine, and the state of the control at these positions. It has its own
// thread, in parallel with the machine. PanelSearch first executes the whole program and stores checkpoints. From these checkpoints it
// finds any line of a long program quickly.
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

/// The state of another channel when the program's own channel is at the restart position. The other channel is then between two blocks, as
/// far as its virtual time allows (session/channels).
struct OtherChannelState {
  std::size_t channel = 0;  // index of the channel
  int number = 1;
  Restart restart;  // The state for the restart. restart.at is the channel's next block, or the block that the channel is executing.
  AlarmReport::Line line;
  std::vector<AlarmReport::Call> calls;
  Placement placement;
  std::optional<Control::Meeting> waits;  // the meeting at which the channel waits; nullopt: the channel does not wait
  bool in_block = false;
  bool is_over = false;      // true if the program of the channel has ended
  std::uint64_t blocks = 0;  // number of blocks that the channel has executed
};

/// A position at which the program could continue.
struct RestartPoint {
  Restart restart;
  AlarmReport::Line line;
  std::vector<AlarmReport::Call> calls;
  Placement placement;                            // position of the work coordinate system in machine coordinates
  Stepping::Memory memory;                        // snapshot of the run when its control has reached this position
  bool in_block = false;                          // true if the position is over a drilled hole of a canned cycle
  std::optional<BlockSearch> by_control;          // Result of the control's own block search; nullopt if the control has no block search.
  std::vector<OtherChannelState> other_channels;  // states of the other channels when the control has reached this position
};

class PanelSearch {
 public:
  struct SearchRequest {
    StopPoint target;
    // Number of the drilled hole of a canned cycle over which the program continues; 0: it continues before the block.
    std::uint32_t hole = 0;
    // True: the search also executes the block search of the control itself. This needs one more execution of the program.
    bool by_control = false;
    // The number of blocks that each channel must have executed at the restart position, by index of the channel. Empty: the virtual time
    // of the program's own channel determines the positions of the other channels.
    std::vector<std::uint64_t> blocks{};
    friend bool operator==(const SearchRequest&, const SearchRequest&) = default;
  };
  struct Answer {
    bool ready = false;
    // the restart position; nullptr although `ready` is true: no restart position matches the request
    std::shared_ptr<const RestartPoint> place{};
    std::string error{};  // the reason why there is no restart position
  };

  explicit PanelSearch(SessionOpener opens);
  ~PanelSearch();
  PanelSearch(const PanelSearch&) = delete;  // Copying is disabled because the search thread uses this object.
  PanelSearch& operator=(const PanelSearch&) = delete;

  /// Discards all results and starts a search in a run with this start position and these switches.
  void begin(const PanelStart& start);
  /// Returns at once what is known about the request so far. A request that differs from the previous request starts a new search.
  Answer find(const SearchRequest& request);

 private:
  /// The session of the search, and the data that refer to this session.
  struct Run {
    std::unique_ptr<Session> session;
    std::unique_ptr<Checkpoints> checkpoints;
    std::unique_ptr<Stepping> stepping;
    std::string error;  // the reason why the session could not be opened; empty: the session is open
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
  std::vector<OtherChannelState> other_channels();
  void find_next(OtherChannelState& channel);
  std::optional<BlockSearch> search_by_control(const StopPoint& target);
  std::unique_ptr<Session> open();

  const SessionOpener opens_;
  // Only the search thread uses the members below.
  Run run_;
  PanelStart start_;
  bool own_is_over_ = false;  // On a machine with several channels: true if the program of the own channel has ended.
  std::atomic<bool> stops_{false};

  std::mutex lock_;
  std::condition_variable wakes_;
  bool ends_ = false;
  std::optional<PanelStart> to_begin_;
  std::optional<SearchRequest> request_;
  Lang lang_{};
  bool searching_ = false;
  // the restart position that answers the last request, or the reason why there is none; nullopt: the search is not complete
  std::optional<Answer> answer_;
  Thread thread_;
};

}  // namespace kadr
