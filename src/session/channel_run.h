#pragma once
// One channel on its way: program → control → path → machine → Steps → whoever looks. The one place where the rooms are put together; the
// channels of one machine side by side: session/channels.

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "config/machine_profile.h"
#include "config/setup.h"
#include "control/control.h"
#include "machine/gear_watch.h"
#include "machine/plc.h"
#include "machine/virtual_machine.h"
#include "machine/whirl.h"
#include "motion/look_ahead/look_ahead.h"
#include "motion/time/steps.h"
#include "path/contour/contour_corners.h"
#include "path/contour/queued_compensation.h"
#include "path/contour/radius_compensation.h"
#include "session/run_ahead.h"

namespace kadr {

/// Virtual time since the start, s.
struct VirtualTime {
  double now = 0;
  double cutting = 0;  // of it at feed
};
VirtualTime virtual_time(const TimeSplit& split);

/// Shown how far a run has come: a bar.
class Onlooker {
 public:
  virtual ~Onlooker() = default;
  /// Something is to be shown; asked often.
  virtual bool is_due() const = 0;
  /// The control stands still meanwhile.
  virtual void show(const Control& control) = 0;
};

/// What looks at a run.
struct Outlets {
  std::function<void(const Step&)> step{};  // after the machine has taken its action; missing: nobody looks
  /// The same with the time that the machine takes, where something limits the speed (ChannelRun::look_ahead): later then, `longer` s than
  /// it was timed.
  std::function<void(const Step&, double longer)> timed{};
  std::function<void(const AlarmReport&)> warning;
  /// An alarm; true: go on with the next block (checking).
  std::function<bool(const AlarmReport&)> alarm;
  Onlooker* onlooker = nullptr;                     // shown the run now and then
  TimeEstimate* clock = nullptr;                    // times the steps; missing: counted here, if somebody asks
  bool wants_times = false;                         // of the steps: who looks asks for them always
  std::function<void(const Action&)> programmed{};  // each action before cutter radius compensation
  std::function<bool()> writable{};                 // all that was handed over could be written; missing: nothing is written
  StopToken stop{};                                 // asked after each batch
  bool works_long = false;                          // on each step: writes or draws it
  bool silent = false;                              // steps and warnings are not handed over: the program is only looked through
};

/// How a run came to its end.
struct Stopped {
  std::optional<AlarmReport> report{};          // the alarm that stopped it, if one did
  std::optional<ToolPosition> machine_stood{};  // where, if that is not where the control is: it was ahead, or knows no offset
  int channel = 0;                              // in which the alarm arose, if not in this one (several channels)
};

/// The machine's logic, and the channels it acts on.
struct Logic {
  Plc plc;
  std::vector<Control*> channels;
};

/// One channel on its way: its control, its part of the machine, its clock. What it is made of must outlive it.
class ChannelRun {
 public:
  ChannelRun(Control& control, const MachineProfile& profile, const Setup& setup, const Outlets& outlets, Logic& logic);
  ChannelRun(const ChannelRun&) = delete;  // the control calls it back
  ChannelRun& operator=(const ChannelRun&) = delete;
  ~ChannelRun();

  enum class State : std::uint8_t { running, waiting, held, stopped, ended };
  /// Carries out what the control hands over at once.
  ///   waiting  for other channels: Control::meeting()
  ///   held     before a block: Control::holds_before() asked for it
  ///   stopped  by an alarm: stopped() tells
  State step();
  /// Something that all channels do together happens now: to the outlets.
  void show(const Action& action);
  const Stopped& stopped() const { return stopped_; }
  /// It does not go on, for what is no fault of a block.
  void refuse(const Alarm& alarm);
  void warn(const AlarmReport& warning);

  /// Virtual time in s, waiting included. Counts from the first call on, unless the outlets have a clock.
  double now();
  /// It has waited for other channels.
  void wait_until(double at);
  double waited() const { return now_.waited; }

  /// From here on Outlets::timed gets what these rules make of the steps. Of a channel alone: several wait for each other by their
  /// programmed times, and their speeds are not planned.
  void look_ahead(const SpeedRules& rules);
  /// Nothing follows: what the rooms hold back to see ahead is let out, as if the program ended here.
  ///   returns  stopped  by an alarm of theirs
  State let_out();
  void finish();
  /// Blocks that the control has carried out, as far as the rooms after it have come.
  std::uint64_t blocks() const { return blocks_; }
  /// The control, to be asked for something: it stands still, as far ahead as it goes.
  Control& settled();
  /// Where the machine stands.
  const ToolPosition& position() const { return machine_.position(); }
  void stand_at(const Axes& machine);

  // ---- axes that hang on those of other channels (nct 20.2, 20.3)
  void hang(std::size_t axis, bool on) { machine_.hang(axis, on); }
  /// The axis goes along to there.
  ///   alarms  as VirtualMachine::follow()
  Status lead(std::size_t axis, double machine);
  /// The axis drives that of another channel, which drives this one; or each its own again.
  void exchange(std::size_t axis, ChannelRun& with, std::size_t other, bool on);
  /// What stays so, of an exchange: not where the axes stand.
  void exchange_limits(std::size_t axis, ChannelRun& with, std::size_t other) { machine_.exchange(axis, with.machine_, other); }
  /// From here on the clock of the outlets counts; it goes on as the one before stood, but for the times spent so far.
  void change_clock();
  /// The alarm that stopped it is answered for: it may go on.
  void acknowledge() { stopped_ = {}; }

  /// What is remembered from step to step, its own.
  struct Clocks {
    double waited = 0;      // s, in all
    double goes_on_at = 0;  // time at which it waited last …
    double spent_then = 0;  // … and what it had spent until then: no sum that rounding could put out of order
    bool too_fast_told = false;
    WhirlWatch whirls{};
    GearWatch gear{};
  };
  /// All that decides how it goes on, its rooms included: a value.
  struct Memory {
    Snapshot control;
    std::vector<RunAhead::Batch> to_come;  // that the control had carried out already
    ContourCorners::Memory corners;
    std::shared_ptr<const RadiusCompensation::Memory> compensation;
    std::shared_ptr<const QueuedCompensation::Memory> queued;
    VirtualMachine::Memory machine;
    std::optional<TimeEstimate> clock;
    std::optional<LookAhead::Memory> look_ahead;
    Clocks own;
    Stopped stopped;
  };
  /// Nothing while the control waits for a probe.
  std::optional<Memory> memory();
  /// Goes on from there.
  ///   alarms  those of Control::restore()
  Status remember(const Memory& memory);

 private:
  Control::State next_batch();
  std::optional<CompensationFault> compensate(Control::State state, bool corner_failed);
  bool beside_contour() const { return queued_ ? queued_->beside() : compensation_.beside(); }
  State take(Control::State state);
  void hand_out(ToolPosition from);
  void give(Steps& steps, const Action& action);
  bool is_suspect(const Action& action) const;
  void watch_feed(const Step& step);
  void watch_whirl(const Step& step);
  void watch_gear(const Action& action);
  TimeEstimate& clock();
  VirtualTime spent() { return virtual_time(clock().split()); }
  void note_place();
  State stop(const AlarmReport& report);
  bool goes_on_after(const std::optional<CompensationFault>& fault);

  Control& control_;
  const Setup& setup_;
  const bool knows_rates_;  // a machine is chosen, or the set-up states rates
  const Outlets& outlets_;
  Logic& logic_;
  ContourCorners corners_;
  RadiusCompensation compensation_;
  std::optional<QueuedCompensation> queued_;  // instead, for a control that queues its contours
  VirtualMachine machine_;
  Rates rates_;
  double least_most_;                      // of the axes' rapid rates
  TimeEstimate* clock_;                    // of the outlets, or …
  std::optional<TimeEstimate> own_clock_;  // … the one begun when somebody asked; else nullptr
  std::optional<LookAhead> look_ahead_;    // where something limits the speed
  Clocks now_;
  ActionBatch batch_;
  std::optional<RunAhead> ahead_;            // where nothing after the control tells it what to do
  std::deque<RunAhead::Batch> to_come_;      // of a snapshot: the control is ahead by them
  std::vector<AlarmReport> early_warnings_;  // of the batch taken last
  unsigned steps_ = 0;
  std::uint64_t blocks_ = 0;
  Stopped stopped_;
};

}  // namespace kadr
