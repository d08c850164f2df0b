#pragma once
// What looks at a fuzzed run: every action, step and alarm is checked; statistics, picture, trace and texts are made of them; a digest
// tells two runs apart.

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "machine/virtual_machine.h"
#include "motion/time/steps.h"
#include "out/picture/plot.h"
#include "out/text/summary.h"
#include "out/trace/trace.h"
#include "run_program.h"
#include "session/session.h"

namespace kadr::fuzz {

class Looks {
 public:
  /// Attaches itself to the session's own channel; both must outlive the run.
  Looks(const Shop& shop, Session& session);

  /// The state before the next block is kept: a faulty one changes nothing of it.
  void before_block();
  /// What was kept belongs to another block.
  void forget_block() { before_is_kept_ = false; }
  /// Asked at each alarm: does the run go on with the next block?
  std::function<bool()> goes_on_after_alarm = [] { return true; };
  /// The end of the motions is not known any more: a session was restored without begin_at().
  bool jumps = false;
  /// After the end: summary, trace, state.
  void finish();

  /// The session is asked to stop after so many actions more.
  void stop_after(std::size_t most, std::atomic<bool>& flag) { last_action_ = actions_ + most, stop_ = &flag; }
  std::size_t actions() const { return actions_; }
  std::size_t alarms() const { return alarms_; }

  /// Where the run is looked at from, for another run that goes on from there.
  struct Place {
    ToolPosition stand;
    std::optional<FrameChange> frame;  // nothing: not known
  };
  Place place() const { return {stand_, frame_}; }
  void begin_at(const Place& place);
  /// Of each step and alarm so far, in order.
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
  Ending before_block_;
  bool before_is_kept_ = false;
  std::size_t kept_ = 0;
  std::size_t actions_ = 0, last_action_ = 0;
  std::atomic<bool>* stop_ = nullptr;
  std::size_t alarms_ = 0;
  std::size_t shown_ = 0;
  std::vector<std::uint64_t> digest_;
};

}  // namespace kadr::fuzz
