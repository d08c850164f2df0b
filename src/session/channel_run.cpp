// ChannelRun: runs the program of one channel through the rooms: program → control → path → machine → Steps → observers. It is used by
// session/channels and cli.

#include "session/channel_run.h"

#include <algorithm>
#include <utility>

#include "action/by_kind.h"
#include "session/plc_commands.h"

namespace kadr {
namespace {

constexpr unsigned shown_each = 64;  // number of batches between two updates of the progress display

/// Converts the control's state after a batch of actions to the value that the corner calculation (CornerResolver) needs: whether more
/// actions, an alarm or nothing follows.
CornerResolver::Follows follows_in(Control::State state) {
  switch (state) {
    case Control::State::running:
    case Control::State::held: return CornerResolver::Follows::more;
    case Control::State::stopped: return CornerResolver::Follows::alarm;
    default: return CornerResolver::Follows::nothing;
  }
}

/// True if the control has more batches that can be executed at once.
bool goes_on(Control::State state) { return state == Control::State::running || state == Control::State::held; }

/// Computes all corners of a contour at once, and its compensated path if its first motion starts compensation (Control::find_corners). A
/// control that checks a whole contour before it executes the contour calls this function.
std::optional<Alarm> corners_of(ActionBatch& contour, const Axes& from) {
  const ToolPosition start{from, from, nullptr};
  if (const auto fault = CornerResolver(start).take(contour, CornerResolver::Follows::nothing)) return fault->alarm;
  const Motion* const first = contour.empty() ? nullptr : motion_of(contour[0]);
  if (first == nullptr || first->side_step != SideStep::begins) return std::nullopt;
  const auto fault = RadiusCompensation(start).take(contour, true);
  return fault ? std::optional(fault->alarm) : std::nullopt;
}

}  // namespace

VirtualTime virtual_time(const TimeSplit& split) { return {split.total(), split.cutting}; }

ChannelRun::ChannelRun(Control& control, const MachineProfile& profile, const Setup& setup, const Outlets& outlets, Logic& logic)
    : control_(control),
      setup_(setup),
      knows_rates_(profile.id != MachineProfile{}.id ||
                   std::any_of(setup.machine.begin(), setup.machine.end(), [](const auto& axis) { return axis.second.rapid.has_value(); })),
      outlets_(outlets),
      logic_(logic),
      corners_(control.tool_position()),
      compensation_(control.tool_position()),
      machine_(control.axes(), control.rotary(), profile, setup, control.tool_position()),
      rates_(rates_of(profile, setup, control.axes())),
      lowest_rapid_rate_(rates_.least_most()),
      clock_(outlets.clock) {
  if (outlets.wants_times) (void)clock();
  control.on_warning = [this](const AlarmReport& warning) {
    if (!(ahead_ && ahead_->keep(warning))) warn(warning);
  };
  control.find_corners = corners_of;
  if (control.queues_compensation()) queued_.emplace(control.tool_position());
  for (std::size_t a = 0; a < control.axes().size(); ++a) {
    const auto [least, most] = control.limits_by_file(a);
    machine_.limit(a, least, most);
  }
  if (control.has_machine_parameters()) machine_.obey_parameters(setup);
  control.on_signal = [this](const std::string& name, bool on) { machine_.set_signal(name, on); };
  const bool answers = machine_.has_limits() || !logic.plc.idle();
  if (answers) control.return_each_block();
  if (!answers && logic.channels.size() == 1 && !control.on_changes && !control.holds_before) ahead_.emplace(control);
  if (logic.plc.idle()) return;
  control.on_block = [this](const Origin& origin, bool at_end) { apply(logic_.plc.block(origin, at_end), control_, logic_.channels); };
}

ChannelRun::~ChannelRun() {
  ahead_.reset();  // the control's thread calls functions of this object, so the thread must end before the object is destroyed
  control_.on_block = nullptr;
  control_.on_signal = nullptr;
  control_.on_warning = nullptr;
}

/// Stores the machine's position in `stopped_` while cutter compensation is active. The tool is then next to the programmed point, and the
/// control knows only the programmed point.
void ChannelRun::note_position() {
  if (off_contour()) stopped_.machine_stood = machine_.position();
}

ChannelRun::State ChannelRun::stop(const AlarmReport& report) {
  note_position();
  stopped_.report = report;
  return State::stopped;
}

/// Returns the control's state and stores its next batch of actions in `batch_`. The rooms lang and control convert blocks to actions.
Control::State ChannelRun::next_batch() {
  if (!to_come_.empty()) {
    RunAhead::Batch next = std::move(to_come_.front());
    to_come_.pop_front();
    batch_ = std::move(next.actions);
    for (const AlarmReport& warning : next.warnings) warn(warning);
    return next.state;
  }
  if (ahead_ && ahead_->is_going()) {
    const Control::State state = ahead_->take(batch_, early_warnings_);
    for (const AlarmReport& warning : early_warnings_) warn(warning);
    return state;
  }
  constexpr double ms = 1000;
  if (control_.reads_clock()) control_.set_time(now() * ms, spent().cutting * ms);
  const Control::State state = control_.run(batch_);
  // A thread saves time only if path and machine have about as much work as the control. Otherwise the transfer of batches between the
  // threads costs more time than it saves.
  const bool contour = queued_ ? queued_->at_work() : compensation_.at_work();
  const bool pays = (outlets_.works_long || contour) && !control_.holds_before;
  if (ahead_ && pays && state == Control::State::running && !control_.returns_each_block()) ahead_->start();
  return state;
}

Control& ChannelRun::settled() {
  if (ahead_) ahead_->settle();
  return control_;
}

void ChannelRun::warn(const AlarmReport& warning) {
  const bool is_disabled = std::find(setup_.disabled.begin(), setup_.disabled.end(), warning.alarm.id) != setup_.disabled.end();
  if (!outlets_.silent && !is_disabled) outlets_.warning(warning);
}

ChannelRun::State ChannelRun::step() { return take(next_batch()); }

ChannelRun::State ChannelRun::let_out() {
  batch_.clear();
  if (queued_) batch_.add().what = CompensationBreak{};
  const State state = take(Control::State::ended);
  finish();
  return state;
}

std::optional<CompensationFault> ChannelRun::compensate(Control::State state, bool corner_failed) {
  const bool last = corner_failed || !goes_on(state);
  if (!queued_) return compensation_.take(batch_, last);
  return queued_->take(batch_, last ? QueuedCompensation::Follows::nothing : QueuedCompensation::Follows::more);
}

/// Processes the control's batch of actions in the rooms after control: path, machine, and then the outlets (the observers of the run).
ChannelRun::State ChannelRun::take(Control::State state) {
  if (!ahead_ || !ahead_->is_going()) blocks_ = control_.blocks();
  else if (!batch_.empty()) blocks_ = batch_.back().origin.number;
  // true: the control has executed more batches than path and machine, so it may be queried only through settled()
  const bool is_ahead = (ahead_ && ahead_->is_going()) || !to_come_.empty();
  // room path: computes corners that the program does not state, and the arcs that replace corners
  const auto corner_fault = corners_.take(batch_, follows_in(state));
  if (outlets_.programmed && !outlets_.silent)
    for (const Action& action : batch_) outlets_.programmed(action);
  const auto fault = compensate(state, corner_fault.has_value());  // room path: applies cutter radius compensation
  ToolPosition before = machine_.position();
  const auto follows = goes_on(state) ? VirtualMachine::Follows::more : VirtualMachine::Follows::nothing;
  const auto taken =
      // room machine: checks limits and zones, and executes probe motions
      machine_.take(batch_, follows, [this](const ProbeAnswer& touched) { control_.answer(touched); });
  batch_.cut(taken.done);
  deliver(std::move(before));
  if (!logic_.plc.idle())
    for (const Action& action : batch_) apply(logic_.plc.action(action), control_, logic_.channels);
  if (taken.alarm) {
    const AlarmReport report = settled().report_for(*taken.alarm, taken.origin);
    // from now on the control passes the actions of each block separately, so that it executes a block only after the machine has accepted
    // the previous one
    if (taken.refused) control_.refused();
    if (!outlets_.alarm(report)) {
      stopped_.machine_stood = machine_.position();
      return stop(report);
    }
    if (taken.refused) return State::running;
  }
  for (const CompensationFault& cut : queued_ ? queued_->warnings() : compensation_.warnings()) {
    AlarmReport report = settled().report_for(cut.alarm, cut.origin);
    report.other = settled().line_at(cut.other);
    warn(report);
  }
  if (!can_continue_after(fault) || !can_continue_after(corner_fault)) return State::stopped;
  if (state == Control::State::stopped || (!is_ahead && control_.is_stopped())) {
    const AlarmReport report = control_.report();
    if (!outlets_.alarm(report)) return stop(report);
    control_.go_on();
  }
  if (state == Control::State::ended) {
    constexpr double ms = 1000;
    if (control_.reads_clock()) control_.set_time(now() * ms, spent().cutting * ms);
    note_position();
    return State::ended;
  }
  if (outlets_.writable && !outlets_.writable()) return State::stopped;
  if (outlets_.stop.requested()) {
    const AlarmReport report = settled().report_for(alarm(AlarmId::interrupted, {}), batch_.empty() ? Origin() : batch_.back().origin);
    (void)outlets_.alarm(report);
    return stop(report);
  }
  if (outlets_.progress_display != nullptr && ++steps_ % shown_each == 0 && outlets_.progress_display->is_due())
    outlets_.progress_display->show(settled());
  if (state == Control::State::held) return State::held;
  return state == Control::State::waiting ? State::waiting : State::running;
}

/// Reports an alarm of room `path`, at which the control has already executed blocks after the faulty block. Returns false if the observer
/// stops the run.
bool ChannelRun::can_continue_after(const std::optional<CompensationFault>& fault) {
  if (!fault) return true;
  const AlarmReport report = settled().report_for(fault->alarm, fault->origin);
  if (outlets_.alarm(report)) return true;
  stopped_.machine_stood = machine_.position();
  stopped_.report = report;
  return false;
}

void ChannelRun::stand_at(const Axes& machine) {
  settled().stand_at(machine);
  ToolPosition stand = machine_.position();
  stand.machine = machine;
  stand.work = control_.tool_position().work;
  machine_.go_back(stand);
}

void ChannelRun::refuse(const Alarm& alarm) {
  const AlarmReport report = settled().report_for(alarm, settled().origin());
  (void)outlets_.alarm(report);
  (void)stop(report);
}

Status ChannelRun::move_linked_axis(std::size_t axis, double machine) {
  const ToolPosition before = control_.tool_position();
  control_.move_linked_axis(axis, machine);
  const ToolPosition now = control_.tool_position();
  AxisMask moved = 0;
  for (std::size_t i = 0; i < control_.axes().size(); ++i)
    if (i == axis || now.machine[i] != before.machine[i]) moved |= AxisMask{1} << i;
  return machine_.follow(now.work, now.machine, moved);
}

void ChannelRun::exchange(std::size_t axis, ChannelRun& with, std::size_t other, bool on) {
  ToolPosition mine = machine_.position(), its = with.machine_.position();
  std::swap(mine.machine[axis], its.machine[other]);
  control_.exchange_cross_channel(axis, mine.machine[axis], on);
  with.control_.exchange_cross_channel(other, its.machine[other], on);
  machine_.go_back(mine);
  with.machine_.go_back(its);
  exchange_limits(axis, with, other);
}

void ChannelRun::change_clock() {
  const double at = now();
  if (outlets_.clock != nullptr && clock_ != outlets_.clock) {
    if (clock_ != nullptr) *outlets_.clock = *clock_;
    clock_ = outlets_.clock;
    own_clock_.reset();
  }
  if (outlets_.wants_times) (void)clock();
  if (clock_ != nullptr) clock_->start_over();
  now_.continued_at = at;
  now_.spent_then = 0;
}

void ChannelRun::look_ahead(const SpeedRules& rules) {
  look_ahead_.emplace(machine_.roles(), rules, rates_.rapid, [this](const Step& step, double longer) {
    if (outlets_.timed) outlets_.timed(step, longer);
  });
}

void ChannelRun::finish() {
  if (look_ahead_) look_ahead_->finish();
}

std::optional<ChannelRun::Memory> ChannelRun::memory() {
  if (ahead_) ahead_->settle();
  auto control = control_.snapshot();
  if (!control) return std::nullopt;
  Memory now{std::move(*control),
             {to_come_.begin(), to_come_.end()},
             corners_.memory(),
             queued_ ? nullptr : std::make_shared<const RadiusCompensation::Memory>(compensation_.memory()),
             queued_ ? std::make_shared<const QueuedCompensation::Memory>(queued_->memory()) : nullptr,
             machine_.memory(),
             clock_ != nullptr ? std::optional(*clock_) : std::nullopt,
             look_ahead_ ? std::optional(look_ahead_->memory()) : std::nullopt,
             now_,
             stopped_};
  if (ahead_) ahead_->add_to_come(now.to_come);
  return now;
}

Status ChannelRun::resume_from(const Memory& memory) {
  if (ahead_) ahead_->forget();
  KADR_TRY(control_.restore(memory.control));
  to_come_.assign(memory.to_come.begin(), memory.to_come.end());
  corners_.resume_from(memory.corners);
  if (memory.compensation) compensation_.resume_from(*memory.compensation);
  if (queued_ && memory.queued) queued_->resume_from(*memory.queued);
  machine_.resume_from(memory.machine);
  if (memory.clock) clock() = *memory.clock;
  if (look_ahead_ && memory.look_ahead) look_ahead_->resume_from(*memory.look_ahead);
  now_ = memory.own;
  stopped_ = memory.stopped;
  return {};
}

TimeEstimate& ChannelRun::clock() {
  if (clock_ == nullptr) {
    clock_ = &own_clock_.emplace(machine_.roles(), rates_);
    clock_->spindles(setup_);
  }
  return *clock_;
}

double ChannelRun::now() { return now_.continued_at + (spent().now - now_.spent_then); }

void ChannelRun::wait_until(double at) {
  const double from = now();
  if (!(at > from)) return;
  now_.waited += at - from;
  now_.continued_at = at;
  now_.spent_then = spent().now;
}

/// Passes the batch to the outlets (trace, summary, plot). Each action is passed as a step, with the tool position and the time at its
/// start.
///   from  tool position before the batch
void ChannelRun::deliver(ToolPosition from) {
  const auto controls = [](const auto& space) { return space && space->controls_tip(); };
  const bool led = controls(from.space) || std::any_of(batch_.begin(), batch_.end(), [&](const Action& action) {
                     const auto* const frame = std::get_if<FrameChange>(&action.what);
                     return frame != nullptr && controls(frame->placement.space);
                   });
  const auto watched = [this](const Action& action) {
    return (!now_.too_fast_reported && is_suspect(action)) || now_.gear.concerns(action);
  };
  const bool looks_on = ((outlets_.step || outlets_.timed) && !outlets_.silent) || clock_ != nullptr;
  if (!looks_on && !led && std::none_of(batch_.begin(), batch_.end(), watched)) return;
  Steps steps(machine_.roles(), std::move(from), clock_);
  for (const Action& action : batch_) give(steps, action);
}

void ChannelRun::show(const Action& action) {
  Steps steps(machine_.roles(), machine_.position(), clock_);
  give(steps, action);
}

void ChannelRun::give(Steps& steps, const Action& action) {
  const double begins = outlets_.step && clock_ != nullptr ? now() : 0;
  steps.give(action, begins, [this](const Step& step) {
    if (outlets_.silent) return;
    // False for an action without motion, e.g. a tool change. The observer `step` receives it only after the look-ahead has passed on all
    // earlier motions of the tool.
    const bool moves = step.motion() != nullptr;
    if (moves && outlets_.step) outlets_.step(step);
    if (look_ahead_) look_ahead_->consume(step);
    else if (outlets_.timed) outlets_.timed(step, 0);
    if (!moves && outlets_.step) outlets_.step(step);
    if (knows_rates_ && !now_.too_fast_reported && is_suspect(step.action)) watch_feed(step);
    if (step.from.space && step.from.space->controls_tip()) watch_singularity(step);
    if (now_.gear.concerns(step.action)) watch_gear(step.action);
  });
}

/// True for a motion whose feed exceeds the lowest rapid rate of all axes, so that some axis may be too slow. Then watch_feed() must
/// examine the motion.
bool ChannelRun::is_suspect(const Action& action) const {
  const auto* const motion = motion_of(action);
  return motion != nullptr && motion->feed > lowest_rapid_rate_ && motion->unit == FeedUnit::mm_per_min;
}

void ChannelRun::watch_singularity(const Step& step) {
  const auto whirl = now_.whirls.look(step);
  if (whirl)
    warn(settled().report_for(warning(AlarmId::axis_whirls, {}, control_.axes()[whirl->axis], whirl->degrees, whirl->tip_travel),
                              step.action.origin));
}

void ChannelRun::watch_gear(const Action& action) {
  if (const auto fast = now_.gear.look(action, control_.axes(), rates_.most))
    warn(settled().report_for(warning(AlarmId::gear_too_fast, {}, control_.axes()[fast->axis], fast->speed, rates_.most[fast->axis]),
                              action.origin));
}

/// Warns, once in a run, of a feed that an axis cannot reach. The axis then moves at its rapid rate, which determines the duration of the
/// motion.
void ChannelRun::watch_feed(const Step& step) {
  constexpr double rounding = 1e-9;
  const Motion& motion = *step.motion();
  const SlowestAxis slowest = slowest_axis(step.roles, step.curve(), motion, rates_.most);
  if (!(slowest.minutes > step.curve().length(motion.along) / motion.feed * (1 + rounding))) return;
  const Alarm reported = warning(AlarmId::feed_above_rapid, {}, motion.feed, control_.axes()[slowest.axis], rates_.most[slowest.axis]);
  warn(settled().report_for(reported, step.action.origin));
  now_.too_fast_reported = true;
}

}  // namespace kadr
