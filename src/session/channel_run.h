#pragma once
// ChannelRun: runs one channel: program → control → path → machine → Steps → observers. This is the one place where these rooms are
// connected. session/channels runs the channels of one machine in parallel.

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
  double cutting = 0;  // part of `now` spent at feed
};
VirtualTime virtual_time(const TimeSplit& split);

/// Displays the progress of a run, e.g. as a bar.
class Onlooker {
 public:
  virtual ~Onlooker() = default;
  /// Returns true if something is due to be displayed. Called often.
  virtual bool is_due() const = 0;
  /// The control does not run meanwhile.
  virtual void show(const Control& control) = 0;
};

/// The observers of a run.
struct Outlets {
  std::function<void(const Step&)> step{};  // called after the machine has accepted the action; empty: nobody observes
  /// The same with the time that the machine takes, if something limits the speed (ChannelRun::look_ahead): called later, and the step
  /// takes `longer` s more than it was timed.
  std::function<void(const Step&, double longer)> timed{};
  std::function<void(const AlarmReport&)> warning;
  /// Called at an alarm. Returns true to continue with the next block (checking).
  std::function<bool(const AlarmReport&)> alarm;
  Onlooker* onlooker = nullptr;                     // called now and then
  TimeEstimate* clock = nullptr;                    // times the steps; nullptr: the run keeps its own clock, if times are requested
  bool wants_times = false;                         // the steps must always carry times
  std::function<void(const Action&)> programmed{};  // each action before cutter radius compensation
  std::function<bool()> writable{};                 // returns false if output could not be written; empty: nothing is written
  StopToken stop{};                                 // polled after each batch
  bool works_long = false;                          // the observer does much work per step: writes or draws it
  bool silent = false;                              // steps and warnings are not passed on: the program is only scanned
};

/// How a run ended.
struct Stopped {
  std::optional<AlarmReport> report{};          // the alarm that stopped it, if one did
  std::optional<ToolPosition> machine_stood{};  // set if it differs from the control's: that was ahead, or ignores an offset
  int channel = 0;                              // the channel that raised the alarm, if it is another one (several channels)
};

/// The machine's logic (PLC), and the channels that it acts on.
struct Logic {
  Plc plc;
  std::vector<Control*> channels;
};

/// One channel in execution: its control, its part of the machine, its clock. The constructor's arguments must outlive it.
class ChannelRun {
 public:
  ChannelRun(Control& control, const MachineProfile& profile, const Setup& setup, const Outlets& outlets, Logic& logic);
  ChannelRun(const ChannelRun&) = delete;  // the control calls it back
  ChannelRun& operator=(const ChannelRun&) = delete;
  ~ChannelRun();

  enum class State : std::uint8_t { running, waiting, held, stopped, ended };
  /// Executes what the control passes on at once.
  ///   waiting  for other channels: Control::meeting()
  ///   held     before a block, by Control::holds_before()
  ///   stopped  by an alarm, see stopped()
  State step();
  /// Passes on to the outlets an action that all channels execute together at this time.
  void show(const Action& action);
  const Stopped& stopped() const { return stopped_; }
  /// Stops the run for a reason that is no fault of a block.
  void refuse(const Alarm& alarm);
  void warn(const AlarmReport& warning);

  /// Virtual time in s, including waiting. It counts from the first call on, unless the outlets have a clock.
  double now();
  /// States that this channel has waited for others until `at`.
  void wait_until(double at);
  double waited() const { return now_.waited; }

  /// From here on Outlets::timed receives the steps timed by these rules. For a single channel only: several channels wait for each other
  /// by their programmed times, and their speeds are not planned.
  void look_ahead(const SpeedRules& rules);
  /// States that nothing follows: actions that the rooms keep back for look-ahead are emitted as if the program ended here.
  ///   returns  stopped  if that raised an alarm
  State let_out();
  void finish();
  /// Number of blocks that the control has executed, as far as the rooms after the control have processed them.
  std::uint64_t blocks() const { return blocks_; }
  /// Returns the control for queries, once its thread has stopped as far ahead as it may go.
  Control& settled();
  /// The position of the machine.
  const ToolPosition& position() const { return machine_.position(); }
  void stand_at(const Axes& machine);

  // ---- axes that are linked to axes of other channels (nct 20.2, 20.3)
  void hang(std::size_t axis, bool on) { machine_.hang(axis, on); }
  /// Moves a linked axis to this machine position.
  ///   alarms  as VirtualMachine::follow()
  Status lead(std::size_t axis, double machine);
  /// Exchanges an axis with one of another channel, so that each program drives the other's axis; or ends the exchange.
  void exchange(std::size_t axis, ChannelRun& with, std::size_t other, bool on);
  /// Exchanges only what stays exchanged, the names, end positions and zones; the positions of the axes are not exchanged.
  void exchange_limits(std::size_t axis, ChannelRun& with, std::size_t other) { machine_.exchange(axis, with.machine_, other); }
  /// From here on the clock of the outlets counts. It continues the state of the previous clock, but not the time spent so far.
  void change_clock();
  /// Acknowledges the alarm that stopped the run: it may continue.
  void acknowledge() { stopped_ = {}; }

  /// The run's own state between steps.
  struct Clocks {
    double waited = 0;      // s, total
    double goes_on_at = 0;  // time at which the last waiting ended …
    double spent_then = 0;  // … and the time spent until then. Two values, since rounding in a running sum could change the order of steps
    bool too_fast_told = false;
    WhirlWatch whirls{};
    GearWatch gear{};
  };
  /// Everything that determines how the run continues, its rooms included, as a value.
  struct Memory {
    Snapshot control;
    std::vector<RunAhead::Batch> to_come;  // batches that the control had executed ahead
    ContourCorners::Memory corners;
    std::shared_ptr<const RadiusCompensation::Memory> compensation;
    std::shared_ptr<const QueuedCompensation::Memory> queued;
    VirtualMachine::Memory machine;
    std::optional<TimeEstimate> clock;
    std::optional<LookAhead::Memory> look_ahead;
    Clocks own;
    Stopped stopped;
  };
  /// Returns nullopt while the control waits for a probe.
  std::optional<Memory> memory();
  /// Continues from this state.
  ///   alarms  as Control::restore()
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
  const bool knows_rates_;  // a machine is selected, or the set-up states rapid rates
  const Outlets& outlets_;
  Logic& logic_;
  ContourCorners corners_;
  RadiusCompensation compensation_;
  std::optional<QueuedCompensation> queued_;  // replaces compensation_ if the control queues its contours
  VirtualMachine machine_;
  Rates rates_;
  double least_most_;                      // the lowest of the axes' rapid rates
  TimeEstimate* clock_;                    // of the outlets, or …
  std::optional<TimeEstimate> own_clock_;  // … the run's own, created at the first query; until then nullptr
  std::optional<LookAhead> look_ahead_;    // set if something limits the speed
  Clocks now_;
  ActionBatch batch_;
  std::optional<RunAhead> ahead_;            // set if nothing after the control affects what it executes
  std::deque<RunAhead::Batch> to_come_;      // from a snapshot: batches by which the control is ahead
  std::vector<AlarmReport> early_warnings_;  // of the batch read last
  unsigned steps_ = 0;
  std::uint64_t blocks_ = 0;
  Stopped stopped_;
};

}  // namespace kadr
