#pragma once
// Looks: the observer of a fuzzed run. It checks every action, step and alarm, and computes statistics, picture, trace and texts from
// them. Its digest shows whether two runs are the same.

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "machine/virtual_machine.h"
#include "motion/time/steps.h"
#include "out/picture/plot/plot.h"
#include "out/text/summary.h"
#include "out/trace/trace.h"
#include "run_program.h"
#include "session/session.h"

namespace kadr::fuzz {

class Looks {
 public:
  /// Attaches the observer to the session's own channel. Session and observer must both live until the end of the run.
  Looks(const Shop& shop, Session& session);

  /// Saves the state before the next block: a block with an alarm must leave it unchanged.
  void before_block();
  /// Discards the saved state, because it belongs to another block.
  void forget_block() { before_is_saved_ = false; }
  /// Called at each alarm; returns true if the run continues with the next block.
  std::function<bool()> goes_on_after_alarm = [] { return true; };
  /// True if the position is not known any more, since a session was restored without begin_at().
  bool jumps = false;
  /// Call it after the end of the run: checks summary, trace and state.
  void finish();

  /// Sets `flag`, which stops the session, after this number of further actions.
  void stop_after(std::size_t most, std::atomic<bool>& flag) { last_action_ = actions_ + most, stop_ = &flag; }
  std::size_t actions() const { return actions_; }
  std::size_t alarms() const { return alarms_; }

  /// Position and frame in the middle of a run, with which the observer of another run can continue.
  struct Place {
    ToolPosition stand;
    std::optional<FrameChange> frame;  // nullopt: not known
  };
  Place place() const { return {stand_, frame_}; }
  void begin_at(const Place& place);
  /// One hash for each step and alarm so far, in order.
  const std::vector<std::uint64_t>& digest() const { return digest_; }

 private:
  void programmed(const Action& action);
  void stepped(const Step& step);
  void check_motion(const Motion& motion) const;
  bool stopped(const AlarmReport& report);
  void show(const AlarmReport& report);

  const Shop& shop_;
  Session& session_;
  Control& control_;
  ToolPosition stand_;
  std::optional<FrameChange> frame_ = FrameChange{};
  Statistics statistics_;
  Plot plot_;
  TraceWriter trace_;
  AlarmReport last_;
  FinalState before_block_;
  bool before_is_saved_ = false;
  std::size_t saved_ = 0;
  std::size_t actions_ = 0, last_action_ = 0;
  std::atomic<bool>* stop_ = nullptr;
  std::size_t alarms_ = 0;
  std::size_t shown_ = 0;
  std::vector<std::uint64_t> digest_;
};

}  // namespace kadr::fuzz
