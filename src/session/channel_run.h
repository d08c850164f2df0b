#pragma once
// ChannelRun: runs the program of one channel: program → control → path → machine → Steps → observers. Only this class connects these
// rooms. session/channels runs the channels of one machine in parallel.

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "config/machine/machine_profile.h"
#include "config/setup/setup.h"
#include "control/control.h"
#include "machine/gear_watch.h"
#include "machine/plc.h"
#include "machine/rotary_swing.h"
#include "machine/virtual_machine.h"
#include "motion/look_ahead/look_ahead.h"
#include "motion/time/steps.h"
#include "path/compensation/corner_resolver.h"
#include "path/compensation/queued_compensation.h"
#include "path/compensation/radius_compensation.h"
#include "session/run_ahead.h"

namespace kadr {

/// Virtual time since the start, s.
struct VirtualTime {
  double now = 0;
  double cutting = 0;  // the part of `now` that was spent moving at feed
};
VirtualTime virtual_time(const TimeSplit& split);

/// Displays the progress of a run, e.g. as a bar.
class ProgressDisplay {
 public:
  virtual ~ProgressDisplay() = default;
  /// Returns true if the display is due for an update. Called often.
  virtual bool is_due() const = 0;
  /// Updates the display. The control stands still during the call, so it may be queried.
  virtual void show(const Control& control) = 0;
};

/// The observers of a run.
struct Outlets {
  std::function<void(const Step&)> step{};  // called after the machine has accepted an action; empty: nobody observes the steps
  /// Like `step`, but with the time that the machine really takes, if something limits the speed (ChannelRun::look_ahead). This function is
  /// called later than `step`. The machine takes `longer` s more for the step than the time that `step` received.
  std::function<void(const Step&, double longer)> timed{};
  std::function<void(const AlarmReport&)> warning;
  /// Called at an alarm. Returns true to continue with the next block (checking).
  std::function<bool(const AlarmReport&)> alarm;
  ProgressDisplay* progress_display = nullptr;  // called now and then to display the progress
  // computes the times of the steps; nullptr: the run has its own clock, created when times are requested
  TimeEstimate* clock = nullptr;
  bool wants_times = false;                         // steps must always have times
  std::function<void(const Action&)> programmed{};  // called for each action before cutter radius compensation is applied
  std::function<bool()> writable{};                 // returns false if output could not be written; empty: the observers write no output
  StopToken stop{};                                 // polled after each batch
  bool works_long = false;                          // the observer works long on each step, because it writes or draws the step
  bool silent = false;                              // the program is only scanned: steps and warnings are not passed to the observers
};

/// How a run ended.
struct Stopped {
  std::optional<AlarmReport> report{};  // the alarm that stopped the run; nullopt: no alarm
  // the machine's position, if it differs from the control's because the control had read ahead or ignores an offset
  std::optional<ToolPosition> machine_stood{};
  int channel = 0;  // number of the channel that raised the alarm, if another channel did
};

/// The machine's logic (PLC), and the controls of the channels that it acts on.
struct Logic {
  Plc plc;
  std::vector<Control*> channels;
};

/// One channel that is being executed: its control, its axes of the machine, its clock. The constructor's arguments must outlive this
/// object.
class ChannelRun {
 public:
  ChannelRun(Control& control, const MachineProfile& profile, const Setup& setup, const Outlets& outlets, Logic& logic);
  ChannelRun(const ChannelRun&) = delete;  // the control calls back this object
  ChannelRun& operator=(const ChannelRun&) = delete;
  ~ChannelRun();

  enum class State : std::uint8_t { running, waiting, held, stopped, ended };
  /// Executes the next actions that the control passes together.
  ///   waiting  the channel waits for other channels: Control::meeting()
  ///   held     the channel is held before a block, by Control::holds_before()
  ///   stopped  an alarm has stopped the channel: stopped()
  State step();
  /// Passes an action to the outlets that all channels execute together at this time.
  void show(const Action& action);
  const Stopped& stopped() const { return stopped_; }
  /// Stops the run with an alarm whose reason is not a faulty block.
  void refuse(const Alarm& alarm);
  void warn(const AlarmReport& warning);

  /// Virtual time of the channel in s, including the time spent waiting. It counts from the first call of now(), unless the outlets have
  /// a clock.
  double now();
  /// Records that this channel has waited for other channels until the time `at`.
  void wait_until(double at);
  double waited() const { return now_.waited; }

  /// From now on Outlets::timed receives the steps with times computed by these rules. For a single channel only: several channels wait
  /// for each other by their programmed times, and their speeds are not planned.
  void look_ahead(const SpeedRules& rules);
  /// Declares that no action follows: actions that are kept back for look-ahead are passed on as if the program ended here.
  ///   returns  stopped if a kept-back action raised an alarm
  State let_out();
  void finish();
  /// Number of blocks that the control has executed and the later rooms (path, machine) have processed.
  std::uint64_t blocks() const { return blocks_; }
  /// Waits until the control's thread has run as far ahead as it may and has stopped. Returns the control, which the caller may then query.
  Control& settled();
  /// The position of the machine.
  const ToolPosition& position() const { return machine_.position(); }
  void stand_at(const Axes& machine);

  // ---- axes that are linked to axes of other channels (nct 20.2, 20.3)
  void hang(std::size_t axis, bool on) { machine_.hang(axis, on); }
  /// Moves a linked axis to this machine position.
  ///   alarms  as VirtualMachine::follow()
  Status lead(std::size_t axis, double machine);
  /// Exchanges an axis with an axis of another channel, so that each program drives the other's axis; `on` false: ends the exchange.
  void exchange(std::size_t axis, ChannelRun& with, std::size_t other, bool on);
  /// Exchanges the data that belong to the axes themselves (names, end positions and zones), but not their positions.
  void exchange_limits(std::size_t axis, ChannelRun& with, std::size_t other) { machine_.exchange(axis, with.machine_, other); }
  /// Called when the outlets have another clock. From now on the new clock counts. It takes over the state of the previous clock, but not
  /// the time counted so far.
  void change_clock();
  /// Acknowledges the alarm that stopped the run, so that the run may continue.
  void acknowledge() { stopped_ = {}; }

  /// The state of this object between two steps.
  struct Clocks {
    double waited = 0;        // total waiting time, s
    double continued_at = 0;  // time at which the last waiting ended, s
    // time on the clock when the last waiting ended, s; stored separately, since rounding errors of a running sum could reorder steps
    double spent_then = 0;
    bool too_fast_reported = false;
    SingularityWatch whirls{};
    GearWatch gear{};
  };
  /// Everything that determines how the run continues, including the state of path and machine, as a value.
  struct Memory {
    Snapshot control;
    std::vector<RunAhead::Batch> to_come;  // batches that the control had executed ahead of the machine
    CornerResolver::Memory corners;
    std::shared_ptr<const RadiusCompensation::Memory> compensation;
    std::shared_ptr<const QueuedCompensation::Memory> queued;
    VirtualMachine::Memory machine;
    std::optional<TimeEstimate> clock;
    std::optional<LookAhead::Memory> look_ahead;
    Clocks own;
    Stopped stopped;
  };
  /// Returns the state; nullopt while the control waits for a probe.
  std::optional<Memory> memory();
  /// Restores a state; the run continues from there.
  ///   alarms  as Control::restore()
  Status resume_from(const Memory& memory);

 private:
  Control::State next_batch();
  std::optional<CompensationFault> compensate(Control::State state, bool corner_failed);
  bool beside_contour() const { return queued_ ? queued_->beside() : compensation_.beside(); }
  State take(Control::State state);
  void deliver(ToolPosition from);
  void give(Steps& steps, const Action& action);
  bool is_suspect(const Action& action) const;
  void watch_feed(const Step& step);
  void watch_singularity(const Step& step);
  void watch_gear(const Action& action);
  TimeEstimate& clock();
  VirtualTime spent() { return virtual_time(clock().split()); }
  void note_position();
  State stop(const AlarmReport& report);
  bool can_continue_after(const std::optional<CompensationFault>& fault);

  Control& control_;
  const Setup& setup_;
  const bool knows_rates_;  // the rapid rates are known: a machine is selected, or the set-up states them
  const Outlets& outlets_;
  Logic& logic_;
  CornerResolver corners_;
  RadiusCompensation compensation_;
  std::optional<QueuedCompensation> queued_;  // used instead of compensation_ if the control queues its contours
  VirtualMachine machine_;
  Rates rates_;
  double lowest_rapid_rate_;               // the lowest rapid rate of all axes
  TimeEstimate* clock_;                    // the clock in use: that of the outlets, or own_clock_; nullptr: no clock yet
  std::optional<TimeEstimate> own_clock_;  // this object's own clock, created at the first query if the outlets have no clock
  std::optional<LookAhead> look_ahead_;    // set if something limits the speed
  Clocks now_;
  ActionBatch batch_;
  // lets the control run in its own thread; set if nothing that comes after the control affects what it executes
  std::optional<RunAhead> ahead_;
  std::deque<RunAhead::Batch> to_come_;      // batches from a restored snapshot that the control had executed ahead
  std::vector<AlarmReport> early_warnings_;  // warnings of the batch that was read last
  unsigned steps_ = 0;
  std::uint64_t blocks_ = 0;
  Stopped stopped_;
};

}  // namespace kadr
