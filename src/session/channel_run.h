#pragma once
// ChannelRun: runs the program of one channel: program → control → path → machine → Steps → observers. No other class connects these rooms.
// session/channels runs several ChannelRun objects in parallel, one for each channel of a machine.

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

/// Virtual time since the start of the run, s.
struct VirtualTime {
  double now = 0;
  double cutting = 0;  // time spent in motion at feed, s; included in `now`
};
VirtualTime virtual_time(const TimeSplit& split);

/// A display of the progress of a run, e.g. a progress bar.
class ProgressDisplay {
 public:
  virtual ~ProgressDisplay() = default;
  /// Returns true if the display needs an update. ChannelRun calls this function often, so it must be fast.
  virtual bool is_due() const = 0;
  /// Updates the display. ChannelRun stops the control during the call, so this function may query the control.
  virtual void show(const Control& control) = 0;
};

/// The functions of an observer that ChannelRun calls during a run, and the options of the observation.
struct Outlets {
  // A function of the observer that receives each step after the machine has accepted its action; empty: nobody observes the steps.
  std::function<void(const Step&)> step{};
  /// A function of the observer that receives each step later than `step`, with the time that the machine really needs if something limits
  /// its speed (ChannelRun::look_ahead). `longer`: additional time compared with the time that `step` received, s.
  std::function<void(const Step&, double longer)> timed{};
  std::function<void(const AlarmReport&)> warning;
  /// A function of the observer that receives an alarm. It returns true if the run is to continue with the next block, as in a check of the
  /// program.
  std::function<bool(const AlarmReport&)> alarm;
  ProgressDisplay* progress_display = nullptr;  // display of the progress, which ChannelRun updates at intervals; nullptr: no display
  // the clock that computes the times of the steps; nullptr: the run creates its own clock when times are requested
  TimeEstimate* clock = nullptr;
  bool wants_times = false;  // true: the steps must have times even without a clock
  // a function of the observer that receives each action before cutter radius compensation is applied
  std::function<void(const Action&)> programmed{};
  // A function of the observer that returns false if it could not write its output, which ends the run; empty: the observer writes no
  // output.
  std::function<bool()> writable{};
  StopToken stop{};  // a request to stop the run, which ChannelRun checks after each batch of actions
  // true: the observer needs much time for each step, because it writes or draws the step; then a second thread is useful
  bool works_long = false;
  // true: the observers receive neither steps nor warnings, because the program is only scanned
  bool silent = false;
};

/// The way in which a run ended.
struct Stopped {
  std::optional<AlarmReport> report{};  // the alarm that stopped the run; nullopt: the run ended without an alarm
  // position of the machine; nullopt: the control's position is the machine's. The two differ if the control had read ahead or ignores an
  // offset
  std::optional<ToolPosition> machine_stood{};
  int channel = 0;  // number of the other channel whose alarm stopped this one; 0: this channel's own alarm
};

/// The machine's logic (PLC), and the controls of the channels that receive its commands.
struct Logic {
  Plc plc;
  std::vector<Control*> channels;
};

/// One channel while its program runs: the control, the axes on the machine, the clock. The constructor's arguments must outlive the
/// ChannelRun object.
class ChannelRun {
 public:
  ChannelRun(Control& control, const MachineProfile& profile, const Setup& setup, const Outlets& outlets, Logic& logic);
  ChannelRun(const ChannelRun&) = delete;  // not copyable: the control has a pointer to this object
  ChannelRun& operator=(const ChannelRun&) = delete;
  ~ChannelRun();

  enum class State : std::uint8_t { running, waiting, held, stopped, ended };
  /// Executes the next batch of actions of the control. The result `waiting` means that the channel waits for other channels
  /// (Control::meeting), `held` that Control::holds_before() holds the channel before a block, and `stopped` that an alarm has stopped the
  /// channel (see stopped()).
  State step();
  /// Passes to the outlets an action that all channels execute together at the present time, e.g. the end of waiting.
  void show(const Action& action);
  const Stopped& stopped() const { return stopped_; }
  /// Stops the run with an alarm for which no block is the reason.
  void refuse(const Alarm& alarm);
  void warn(const AlarmReport& warning);

  /// Returns the virtual time of the channel, s, including the time spent waiting. Without a clock of the outlets, the time counts from the
  /// first call of now().
  double now();
  /// Records that this channel has waited for other channels until the virtual time `at`, s.
  void wait_until(double at);
  double waited() const { return now_.waited; }

  /// Plans the speeds by these rules from now on: Outlets::timed receives the steps with the planned times. The function may be called only
  /// if there is a single channel: several channels wait for each other according to their programmed times, so their speeds are not
  /// planned.
  void look_ahead(const SpeedRules& rules);
  /// Declares that no action follows. Actions that are stored for look-ahead are passed to the outlets as if the program ended here.
  ///   returns  stopped if a stored action raised an alarm
  State let_out();
  void finish();
  /// Number of blocks that the control has executed and that path and machine have processed.
  std::uint64_t blocks() const { return blocks_; }
  /// Waits until the control's thread has executed as many blocks in advance as it may, and has stopped. Returns the control, which the
  /// caller may then query.
  Control& settled();
  /// Position of the tool on the machine, after the last action that the machine has accepted.
  const ToolPosition& position() const { return machine_.position(); }
  void stand_at(const Axes& machine);

  // ---- axes that are linked to axes of other channels (nct 20.2, 20.3)
  void hang(std::size_t axis, bool on) { machine_.hang(axis, on); }
  /// Moves a linked axis to the position `machine`, in machine coordinates, mm or degrees.
  ///   alarms  as VirtualMachine::follow()
  Status move_linked_axis(std::size_t axis, double machine);
  /// Exchanges an axis with an axis of another channel, so that the program of each channel moves the axis of the other channel. If `on` is
  /// false, the exchange ends.
  void exchange(std::size_t axis, ChannelRun& with, std::size_t other, bool on);
  /// Exchanges the names, end positions and zones of two axes, which belong to the axes themselves, but not their positions.
  void exchange_limits(std::size_t axis, ChannelRun& with, std::size_t other) { machine_.exchange(axis, with.machine_, other); }
  /// Changes to the present clock of the outlets; to be called when the outlets have another clock. The new clock receives the state of the
  /// previous clock, except the time counted so far.
  void change_clock();
  /// Acknowledges the alarm that stopped the run, so that the run may continue.
  void acknowledge() { stopped_ = {}; }

  /// The times of the channel, and the state of its checks, between two steps.
  struct Clocks {
    double waited = 0;        // total waiting time, s
    double continued_at = 0;  // time at which the last waiting ended, s
    // time on the clock when the last waiting ended, s. The value is stored, since rounding errors of a running sum could change the order
    // of steps
    double spent_then = 0;
    bool too_fast_reported = false;
    SingularityWatch whirls{};
    GearWatch gear{};
  };
  /// A snapshot of everything that determines how the run continues, including the state of path and machine.
  struct Memory {
    Snapshot control;
    std::vector<RunAhead::Batch> to_come;  // batches of actions that the control had created in advance, before the machine executed them
    CornerResolver::Memory corners;
    std::shared_ptr<const RadiusCompensation::Memory> compensation;
    std::shared_ptr<const QueuedCompensation::Memory> queued;
    VirtualMachine::Memory machine;
    std::optional<TimeEstimate> clock;
    std::optional<LookAhead::Memory> look_ahead;
    Clocks own;
    Stopped stopped;
  };
  /// Returns a snapshot; nullopt while the control waits for the result of a probe motion.
  std::optional<Memory> memory();
  /// Restores a snapshot, from which the run continues.
  ///   alarms  as Control::restore()
  Status resume_from(const Memory& memory);

 private:
  Control::State next_batch();
  std::optional<CompensationFault> compensate(Control::State state, bool corner_failed);
  bool off_contour() const { return queued_ ? queued_->off_contour() : compensation_.off_contour(); }
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
  const bool knows_rates_;  // true: the rapid rates are known, as a machine is selected or the set-up states them
  const Outlets& outlets_;
  Logic& logic_;
  CornerResolver corners_;
  RadiusCompensation compensation_;
  // the cutter compensation if the control compensates a queue of motions; otherwise compensation_ is used
  std::optional<QueuedCompensation> queued_;
  VirtualMachine machine_;
  Rates rates_;
  double lowest_rapid_rate_;               // the lowest rapid rate of all axes, mm/min
  TimeEstimate* clock_;                    // the clock in use, which is that of the outlets or own_clock_; nullptr: not created yet
  std::optional<TimeEstimate> own_clock_;  // the clock of this object, created when a time is first needed and the outlets have no clock
  std::optional<LookAhead> look_ahead_;    // the look-ahead; nullopt: nothing limits the speed
  Clocks now_;
  ActionBatch batch_;
  // Runs the control in its own thread. It is nullopt if path, machine or the machine's logic can affect what the control executes, so that
  // the control must not execute blocks in advance.
  std::optional<RunAhead> ahead_;
  // batches of actions from a restored snapshot, which are executed before the control creates new ones
  std::deque<RunAhead::Batch> to_come_;
  std::vector<AlarmReport> early_warnings_;  // warnings of the last batch that the control's thread has created
  unsigned steps_ = 0;
  std::uint64_t blocks_ = 0;
  Stopped stopped_;
};

}  // namespace kadr
