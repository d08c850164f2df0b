// PanelMachine, the execution of a run of motion: the session's steps become motion in the time of the servo clock. Used by
// panel/panel_machine.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "action/by_kind.h"
#include "motion/time/steps.h"
#include "panel/panel_machine.h"
#include "texts/grbl_machine.h"
#include "texts/panel.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;

constexpr double farthest = 1e5;  // the longest single motion by hand, mm or degrees

}  // namespace

/// Handles each step before the planner receives it: passes it to the observer, displays a message, holds the program at a stop, and notes
/// the block of a motion.
void PanelMachine::look(ChannelAxes& lane, Control& control, const Step& step) {
  if (looks_on_) looks_on_(step);
  const bool is_own = &lane == lane_;
  const auto hold_next = [&] { is_own ? stepping_->hold_next() : void(lane.holds_next = true); };
  const auto hold_for = [&](const std::string& code, const std::string& message) {
    hold_next();
    panel_state_.why = code;
    panel_state_.message = message;
    panel_state_.stop = control.line_at(step.action.origin);
  };
  by_kind(
      step.action, [&](const FrameChange& frame) { lane.placement = frame.placement; },
      [&](const Message& message) {
        panel_state_.message = message.text;
        if (message.asks) panel_state_.asks = true, asks_ = &control, hold_next();
      },
      [&](const Stop& stop) {
        if (stop.optional && !panel_state_.optional_stop) return;
        hold_next();
        panel_state_.why = stop.optional ? "M1" : "M0";
        panel_state_.stop = control.line_at(step.action.origin);
      },
      [&](const ToolChange& change) {
        if (lane.is_real() && !change.there) hold_for("M6", translated(texts::grbl_machine::tool_by_hand, change.tool));
      },
      [&](const MachineFunction& function) {
        if (!lane.is_real() || function.by_control) return;
        const std::string code = fmt::format("M{}", function.code);
        hold_for(code, translated(texts::grbl_machine::by_hand, code));
      },
      [&](const AuxiliaryFunction& function) {
        if (!lane.is_real()) return;
        const std::string code = fmt::format("{}{:g}", function.address, function.value);
        hold_for(code, translated(texts::grbl_machine::by_hand, code));
      },
      ignores<Motion, Dwell, Spindle, Speed, CoolantSwitch, ToolSelect, SurfaceSpeed, Sync, ZoneChange, Couple, Uncouple, CompensationBreak,
              CompensationCorner, CompensationCheck>);
  if (step.motion() != nullptr) note_motion(lane, control, step);
  lane.take(step);
}

/// Notes the block of a motion that the planner or the machine receives next.
void PanelMachine::note_motion(ChannelAxes& lane, Control& control, const Step& step) {
  const bool is_own = &lane == lane_;
  const Motion* const motion = step.motion();
  const Origin& origin = step.action.origin;
  PanelBlock& pending = lane.pending;
  if (origin.number != lane.modes_of || !pending.modes) {
    pending.modes = std::make_shared<PanelModes>(PanelModes{control.in_force(), control.calls_of(origin), control.lathe_modes()});
    lane.modes_of = origin.number;
  }
  pending.origin = origin;
  pending.work = motion->to, pending.machine = motion->machine;
  pending.placement = lane.placement;
  pending.entered = running_ && running_->of == Run::Of::line;
  pending.factor = factor_of(*motion);
  pending.by_turn = motion->unit == FeedUnit::mm_per_rev;
  pending.number = pending.entered || !is_own ? 0 : origin.number - std::uint32_t(entered_);
  pending.feed = motion->kind == MotionKind::rapid || motion->kind == MotionKind::home ? 0 : step.time.feed;
}

/// Returns the factor of the programmed feed with which the motion is planned.
double PanelMachine::factor_of(const Motion& motion) const {
  return panel_state_.shares.dry_feed > 0 || !AxisMotion::has_override(motion) ? 1 : panel_state_.shares.planned();
}

/// Starts a leg of a channel, that is, the motion up to the next stop. The planner of the leg starts at the position at which the axes will
/// be at rest.
void PanelMachine::begin_leg(std::size_t channel) {
  ChannelAxes& lane = *lanes_[channel];
  Control& control = *session_->channels()[channel].control;
  // The planner of the channel's new leg receives the steps from here on; this function replaces the one that used the planner of the
  // previous leg.
  session_->outlets(channel).step = [this, &lane, &control](const Step& step) { look(lane, control, step); };
  lane.begin_leg(*session_, channel, panel_state_.shares);
  session_->change_outlets();
}

/// Sets the functions that handle waiting codes. A leg ends at a waiting code. A new leg starts when all channels have arrived at this
/// code.
void PanelMachine::watch_channels() {
  if (is_alone()) return;
  ChannelOutlets& together = session_->together();
  together.waits = [this](std::size_t channel, const Control::Meeting& meeting) {
    const auto waits = std::make_shared<PanelMeeting>();
    waits->code = meeting.code;
    for (const auto& lane : lanes_)
      if ((meeting.channels >> lane->number & 1U) != 0) waits->channels.insert(lane->number);
    lanes_[channel]->end_leg(waits, meeting.origin);
  };
  together.over = [this](std::size_t channel) { lanes_[channel]->end_leg(), lanes_[channel]->has_ended = true; };
  together.met = [this](const std::vector<std::size_t>& channels) {
    const auto met = std::make_shared<PanelMeeting>();
    met->is_met = true;
    for (const std::size_t channel : channels) met->channels.insert(lanes_[channel]->number);
    for (const std::size_t channel : channels) {
      if (const PanelMeeting* const before = lanes_[channel]->meeting()) met->code = before->code;
      lanes_[channel]->meet(met);
      begin_leg(channel);
    }
  };
  for (std::size_t i = 0; i < lanes_.size(); ++i)
    if (i != session_->own())
      session_->channels()[i].control->holds_before = [lane = lanes_[i].get(), &control = *session_->channels()[i].control](const Origin&) {
        return lane->enters ? !control.in_entered() : lane->is_held();
      };
}

/// Begins a run of motion.
///   channel  index of the channel of an entered line
void PanelMachine::begin(Run::Of of, std::size_t channel) {
  Run& run = running_.emplace();
  run.of = of, run.channel = channel;
  has_moved_ = true;
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    const bool moves = of == Run::Of::line ? i == channel : !lanes_[i]->has_ended;
    if (moves && !lanes_[i]->waits()) begin_leg(i);
  }
  lane_->on.origin = stepping_->next().value_or(Origin()), lane_->on.entered = false;
  if (of == Run::Of::program) stepping_->begin(how_.value_or(panel_state_.single ? Stepping::How::single : Stepping::How::free));
  play();
}

/// Starts the run of motion. The motion is computed in the next look_round(). The caller therefore gets an answer at once, even if the
/// program calculates for a long time before the first motion.
void PanelMachine::play() {
  panel_state_.mode = PanelMode::running;
  apply_overrides();
}

/// Begins the execution of a line of the operator.
void PanelMachine::begin_line(const std::string& line, std::size_t channel) {
  note_variables(last_line_);
  entering_from_ = session_->channels()[channel].control->blocks();
  tables_before_.reset();
  if (!going_) tables_before_ = session_->control().tables_now();
  if (channel == own_) {
    stepping_->begin_entering(line);
  } else {
    lanes_[channel]->enters = true;
    session_->enter(line, channel);
  }
  begin(Run::Of::line, channel);
}

/// Completes a line of the operator. The channel is then held again before the block at which it was held before this line.
void PanelMachine::end_line() {
  const std::size_t channel = running_->channel;
  ChannelAxes& lane = *lanes_[channel];
  const Control& control = *session_->channels()[channel].control;
  if (channel == own_) {
    stepping_->end_entering(running_->came_to);
    entered_ += control.blocks() - entering_from_;
  } else {
    if (running_->came_to == Session::State::stopped) {
      session_->acknowledge(channel);
      session_->alone(channel);
      (void)session_->run();
    }
    lane.enters = false;
    lane.entered += control.blocks() - entering_from_;
  }
  note_variables(0);
  if (tables_before_) keep_tables(*std::exchange(tables_before_, std::nullopt));
}

/// Returns how far an axis may move in the direction of `sign`: to the end of its travel, but at most as far as it moves in a minute,
/// because the motion is planned at once.
double PanelMachine::way_while_held(std::size_t channel, const std::string& axis, double sign, double feed) const {
  constexpr double without_feed = 5'000;  // mm or degrees
  const ChannelAxes& lane = *lanes_[channel];
  const auto found = std::find(lane.axes.begin(), lane.axes.end(), axis);
  if (found == lane.axes.end()) return sign;
  const auto [least, most] = limits_of(session_->machine(), session_->channels()[channel].setup, axis);
  const double at = standing_plainly(channel).machine[std::size_t(found - lane.axes.begin())];
  const double left = sign > 0 ? most - at : at - least, within = feed > 0 ? std::min(feed, farthest) : without_feed;
  return (sign > 0 ? 1 : -1) * std::min(left, within);
}

PanelMachine::Answer PanelMachine::move_by_hand(std::size_t channel, const std::string& axis, double distance, double feed) {
  ChannelAxes& lane = *lanes_[channel];
  const auto found = std::find(lane.axes.begin(), lane.axes.end(), axis);
  if (found == lane.axes.end()) return Failed(translated(texts::panel::no_such_axis, axis));
  if (!(std::fabs(distance) <= farthest) || !(feed >= 0 && feed <= farthest) || distance == 0)
    return Failed(translated(texts::panel::way_and_feed_wanted));
  const Channel& its = session_->channels()[channel];
  if (its.control->in_block() || its.control->meeting()) return Failed(translated(texts::panel::run_block_first));
  const std::size_t a = std::size_t(found - lane.axes.begin());
  const ToolPosition stand = standing_plainly(channel);
  const auto [least, most] = limits_of(session_->machine(), its.setup, axis);
  Motion motion;
  motion.kind = feed > 0 ? MotionKind::feed : MotionKind::rapid;
  motion.feed = feed;
  motion.named = AxisMask{1} << a;
  motion.exact = true;
  motion.to = stand.work, motion.machine = stand.machine;
  motion.to[a] += distance, motion.machine[a] += distance;
  if (motion.machine[a] < least || motion.machine[a] > most) return Failed(translated(texts::panel::beyond_end, axis));
  begin_by_hand(lane, {motion});
  return {};
}

/// Returns the position without programmed frames and rotations, for a motion along the machine's axes.
ToolPosition PanelMachine::standing_plainly(std::size_t channel) const {
  ToolPosition stand = session_->stand(channel);
  stand.turn.reset(), stand.space.reset();
  return stand;
}

void PanelMachine::begin_by_hand(ChannelAxes& lane, const std::vector<Motion>& motions) {
  const std::size_t number =
      std::size_t(std::find_if(lanes_.begin(), lanes_.end(), [&](const auto& one) { return one.get() == &lane; }) - lanes_.begin());
  const Channel& channel = session_->channels()[number];
  const ToolPosition stand = standing_plainly(number);
  Run& run = running_.emplace();
  run.of = Run::Of::hand;
  run.planned_all = true;
  has_moved_ = true;
  PanelOverrides by_hand = panel_state_.shares;
  by_hand.dry_feed = 0;
  lane.begin_by_hand(channel, session_->machine(), stand, by_hand);
  TimeEstimate times(lane.roles, rates_of(session_->machine(), channel.setup, lane.axes));
  Steps steps(lane.roles, stand, &times);
  for (const Motion& motion : motions) {
    lane.pending = lane.on;
    lane.pending.work = motion.to, lane.pending.machine = motion.machine, lane.pending.feed = motion.feed;
    lane.pending.factor = factor_of(motion);
    Action action;
    action.what = motion;
    steps.give(action, [&](const Step& step) {
      if (looks_on_) looks_on_(step);
      lane.take_by_hand(step);
    });
  }
  lane.end_leg();
  play();
}

/// Executes the program in the session until enough motion is planned for the clock of every channel.
void PanelMachine::provide() {
  const auto any = [this](bool (ChannelAxes::*is)() const) {
    return std::any_of(lanes_.begin(), lanes_.end(), [is](const auto& lane) { return ((*lane).*is)(); });
  };
  const auto must_go_on = [&] {
    return any(&ChannelAxes::wants_more) || !any(&ChannelAxes::is_planned);
  };  // If no leg is being planned, all channels wait or have ended, so the session must continue.
  while (!running_->planned_all && must_go_on() && !any(&ChannelAxes::is_full)) go_on();
  for (const auto& lane : lanes_) lane->go_on();
}

void PanelMachine::go_on() {
  running_->came_to = session_->go_on();
  if (running_->came_to == Session::State::running) return;
  for (const auto& lane : lanes_) lane->end_leg();
  running_->planned_all = true;
}

bool PanelMachine::is_over() const {
  return running_->planned_all && std::all_of(lanes_.begin(), lanes_.end(), [](const auto& lane) { return lane->is_over(); });
}

/// Completes a run of motion. The axes have stopped at its end.
void PanelMachine::end_run() {
  for (const auto& lane : lanes_) lane->settle();
  const Run::Of of = running_->of;
  const Session::State came_to = running_->came_to;
  if (of == Run::Of::line) end_line();
  running_.reset();
  holds_ = lets_go_ = false;
  held_until_.reset();
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    ChannelAxes& lane = *lanes_[i];
    const Axes at = lane.sample().machine;
    const auto is_at = [&](const Axes& there) {
      bool is = true;
      for (std::size_t a = 0; a < lanes_[i]->axes.size() && a < max_axes; ++a) is = is && std::fabs(there[a] - at[a]) < lane.nearly_there();
      return is;
    };
    const Axes& aim = lanes_[i]->pending.machine;  // End position of a motion by hand. Only one channel moves in such a motion.
    const Control& control = *session_->channels()[i].control;
    if (of == Run::Of::hand && !control.meeting() && !control.in_block()) session_->stand_at(i, is_at(aim) ? aim : at);
    // If the axes are at the session's position except for rounding errors of the planner, they get exactly the session's position.
    if (const Axes stand = session_->stand(i).machine; is_at(stand)) lane.stand_at(stand);
  }
  if (of != Run::Of::hand) show_what_is_in_force();
  if (of == Run::Of::program) goes_on_ = came_to == Session::State::held;
  if (going_ && came_to != Session::State::stopped) {
    if (const Answer there = go_on_there(); !there) panel_state_.message = there.error(), panel_state_.mode = PanelMode::standing;
    return;
  }
  going_.reset();
  if (of == Run::Of::hand && probed_axis_) go_to_touch();
  if (running_) return;
  const bool stopped = came_to == Session::State::stopped && of == Run::Of::program;
  if (stopped) panel_state_.mode = PanelMode::alarm;
  else panel_state_.mode = stepping_->next() || goes_on_ ? PanelMode::standing : PanelMode::ended;
  if (of != Run::Of::program) return;
  if (panel_state_.mode == PanelMode::ended) notify("ended");
  else if (panel_state_.mode == PanelMode::standing) notify("stopped", panel_state_.why, stepping_->line().number);
}

/// Updates the displayed modes, because blocks after the last motion may have changed the modes. The work offset is updated too, unless a
/// motion of a compensated contour is not executed yet.
void PanelMachine::show_what_is_in_force() {
  const bool in_contour = is_in_contour();
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    const Control& control = *session_->channels()[i].control;
    PanelBlock& on = lanes_[i]->on;
    on.modes = std::make_shared<PanelModes>(PanelModes{control.in_force(), control.calls(), control.lathe_modes()});
    if (in_contour) continue;
    on.placement = lanes_[i]->placement = control.placement();
    on.work = session_->stand(i).work, on.machine = session_->stand(i).machine;
  }
}

/// Discards the run of motion. The axes stop at their current position.
void PanelMachine::drop_run() {
  for (const auto& lane : lanes_) lane->drop();
  running_.reset();
  going_.reset();
  probed_axis_.reset();
  holds_ = resets_ = lets_go_ = false;
  held_until_.reset();
}

}  // namespace kadr
