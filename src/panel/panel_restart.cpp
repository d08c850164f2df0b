// PanelMachine, the restart in mid-program. The machine first moves to the restart position. Then the control's memory is restored as if
// the program had been executed up to this position. Used by panel/panel_machine; tested by tests/panel/panel_restart_test.cpp.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "panel/panel_machine.h"
#include "texts/panel.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;

std::string no_room() { return translated(texts::panel::no_room_in_word); }

constexpr double nowhere = -1e9;  // a clearance level in mm that is far below every position, so that the path to the block needs no rise
// Tolerance of the end of a path, mm or degrees. It is needed because the user sees the end of the path rounded to thousandths.
constexpr double at_place = 1e-3;

}  // namespace

PanelMachine::Answer PanelMachine::may_go_there() const {
  if (const Answer may = may_begin(); !may) return may;
  for (const Channel& channel : session_->channels())
    if (channel.control->in_block() || channel.control->meeting()) return Failed(translated(texts::panel::reset_block_first));
  return {};
}

/// Returns the restart sheet of a channel for the present position of its axes.
tl::expected<PanelSheet, std::string> PanelMachine::sheet_of_channel(std::size_t channel, const Restart& restart, bool in_block,
                                                                     const WayRules& rules) const {
  Control& control = *session_->channels()[channel].control;
  ToolPosition stand = session_->stand(channel);
  stand.machine = lanes_[channel]->sample().machine;
  auto made = sheet_of(restart, in_block, stand, control.in_force(), rules, control, session_->def());
  if (!made) return Failed(no_room());
  return std::move(*made);
}

tl::expected<std::vector<PanelSheet>, std::string> PanelMachine::sheets(const std::shared_ptr<const RestartPoint>& place,
                                                                        const WayRules& rules) {
  // The result is in shared memory, because the request that fills it may be executed after this call has timed out.
  const auto sheets = std::make_shared<std::vector<PanelSheet>>();
  const Answer answer = ask(
      [sheets, this, place, rules]() -> Answer {
        if (const Answer may = may_go_there(); !may) return may;
        WayRules of_others = rules;
        of_others.clearance =
            nowhere;  // The clearance is a work coordinate of the own channel, so it has no meaning in the other channels.
        auto own = sheet_of_channel(own_, place->restart, place->in_block, rules);
        if (!own) return Failed(own.error());
        sheets->push_back(std::move(*own));
        for (const OtherChannelState& channel : place->other_channels) {
          auto other = sheet_of_channel(channel.channel, channel.restart, channel.in_block, of_others);
          if (!other) return Failed(other.error());
          sheets->push_back(std::move(*other));
        }
        return {};
      },
      Wait::for_end);
  if (!answer) return Failed(answer.error());
  return std::move(*sheets);
}

/// Checks a path against the travel limits of the axes.
///   returns  the end position of the path, or an error sentence
tl::expected<Axes, std::string> PanelMachine::end_of(const PanelPath& path) const {
  const ChannelAxes& lane = *lanes_[path.channel];
  Axes at = lane.sample().machine;
  for (const WayPoint& point : path.points) {
    for (std::size_t a = 0; a < lane.axes.size() && a < max_axes; ++a) {
      if ((point.named >> a & 1U) == 0) continue;
      const auto [least, most] = limits_of(session_->machine(), session_->channels()[path.channel].setup, lane.axes[a]);
      at[a] = point.machine[a];
      if (!(at[a] >= least && at[a] <= most)) return Failed(translated(texts::panel::beyond_end, lane.axes[a]));
    }
    if (!point.rapid && !(point.feed > 0 && point.feed <= 1e5)) return Failed(translated(texts::panel::feed_limits));
  }
  return at;
}

PanelMachine::Answer PanelMachine::check_paths(const std::vector<PanelPath>& paths, const RestartPoint& place) const {
  const auto check_path = [&](std::size_t channel, const Axes& there) -> Answer {
    const auto is_its = [&](const PanelPath& path) { return path.channel == channel; };
    if (std::count_if(paths.begin(), paths.end(), is_its) > 1) return Failed(translated(texts::panel::one_way_wanted));
    const auto path = std::find_if(paths.begin(), paths.end(), is_its);
    const auto end = end_of(path == paths.end() ? PanelPath{channel, {}} : *path);
    if (!end) return Failed(end.error());
    const ChannelAxes& lane = *lanes_[channel];
    for (std::size_t a = 0; a < lane.axes.size() && a < max_axes; ++a)
      if (!(std::fabs((*end)[a] - there[a]) <= at_place))
        return Failed(translated(texts::panel::way_ends_elsewhere, (is_alone() ? "" : fmt::format("{}: ", lane.number)) + lane.axes[a]));
    return {};
  };
  Answer checked = check_path(own_, place.restart.stand.machine);
  for (const OtherChannelState& channel : place.other_channels)
    if (checked) checked = check_path(channel.channel, channel.restart.stand.machine);
  return checked;
}

/// Adds to `going` the lines that a channel must execute before and after the motion along the paths.
///   left  keys of the items that keep their present value; the keys of other channels begin with the channel number
PanelMachine::Answer PanelMachine::prepare(PanelApproach& going, std::size_t channel, const Restart& restart, bool in_block,
                                           const std::set<std::string>& left) const {
  const auto sheet = sheet_of_channel(channel, restart, in_block, {});
  if (!sheet) return Failed(sheet.error());
  std::set<std::string> its = left;
  if (const std::string before = fmt::format("{}/", lanes_[channel]->number); channel != own_) {
    its.clear();
    for (const std::string& key : left)
      if (key.starts_with(before)) its.insert(key.substr(before.size()));
  }
  const ControlDef& def = session_->def();
  const auto before = lines_before(*sheet, its, def), after = lines_after(*sheet, its, def);
  if (!before || !after) return Failed(no_room());
  for (const std::string& line : *before) going.before.push_back({channel, line});
  for (const std::string& line : *after) going.after.push_back({channel, line});
  return {};
}

PanelMachine::Answer PanelMachine::go_there(std::shared_ptr<const RestartPoint> place, const std::set<std::string>& left,
                                            std::vector<PanelPath> paths) {
  return ask([this, place = std::move(place), left, paths = std::move(paths)]() -> Answer {
    if (const Answer may = may_go_there(); !may) return may;
    if (const Answer fits = check_paths(paths, *place); !fits) return fits;
    PanelApproach going;
    going.place = place;
    Answer ready = prepare(going, own_, place->restart, place->in_block, left);
    for (const OtherChannelState& channel : place->other_channels)
      if (ready) ready = prepare(going, channel.channel, channel.restart, channel.in_block, left);
    if (!ready) return ready;
    for (const PanelPath& path : paths)
      if (!path.points.empty()) going.paths.push_back(path);
    panel_state_.message.clear(), panel_state_.why.clear();
    panel_state_.alarm.reset();
    notify("restart", place->line.text, place->line.number);
    going_ = std::move(going);
    return go_on_there();
  });
}

PanelMachine::Answer PanelMachine::move_along_path(const std::vector<WayPoint>& points) {
  return ask([this, points]() -> Answer {
    if (const Answer may = may_begin(); !may) return may;
    const Control& control = session_->control();
    if (control.in_block() || control.meeting()) return Failed(translated(texts::panel::run_block_first));
    const PanelPath own{own_, points};
    if (const auto end = end_of(own); !end) return Failed(end.error());
    if (points.empty()) return Failed(translated(texts::panel::way_wanted));
    match_paths(own);
    return {};
  });
}

void PanelMachine::match_paths(const PanelPath& path) {
  std::vector<Motion> motions;
  ToolPosition at = standing_plainly(path.channel);
  for (const WayPoint& point : path.points) {
    Motion& motion = motions.emplace_back();
    motion.kind = point.rapid ? MotionKind::rapid : MotionKind::feed;
    motion.feed = point.feed;
    motion.named = point.named;
    motion.exact = true;
    for (std::size_t a = 0; a < max_axes; ++a) {
      if ((point.named >> a & 1U) == 0) continue;
      at.work[a] += point.machine[a] - at.machine[a];
      at.machine[a] = point.machine[a];
    }
    motion.to = at.work, motion.machine = at.machine;
  }
  begin_by_hand(*lanes_[path.channel], motions);
}

/// Continues the move to the restart position with its next line or path. The machine calls it when the axes are at rest.
PanelMachine::Answer PanelMachine::go_on_there() {
  PanelApproach& going = *going_;
  if (!going.before.empty()) {
    execute(going.before);
    return {};
  }
  if (!going.paths.empty()) {
    const PanelPath next = std::move(going.paths.front());
    going.paths.pop_front();
    match_paths(next);
    return {};
  }
  if (!going.is_there) {
    if (const Answer there = arrive(*going.place); !there) {
      going_.reset();
      return there;
    }
    going.is_there = true;
  }
  if (!going.after.empty()) {
    execute(going.after);
    return {};
  }
  going_.reset();
  panel_state_.mode = PanelMode::standing;
  panel_state_.why = "restart";
  return {};
}

void PanelMachine::execute(std::deque<PanelApproach::Line>& lines) {
  const PanelApproach::Line line = std::move(lines.front());
  lines.pop_front();
  begin_line(line.text, line.channel);
}

/// Sets the state as if the program had been executed up to the restart position. The machine calls it when the axes have arrived at this
/// position.
PanelMachine::Answer PanelMachine::arrive(const RestartPoint& place) {
  lane_->stand_at(place.restart.stand.machine);
  for (const OtherChannelState& channel : place.other_channels) lanes_[channel.channel]->stand_at(channel.restart.stand.machine);
  return resume_from(place);
}

/// Restores the state that the control has after the program was executed up to the restart position.
PanelMachine::Answer PanelMachine::resume_from(const RestartPoint& place) {
  if (const Status restored = stepping_->restore(place.memory); !restored) return Failed(translated(texts::panel::called_file_changed));
  obey_switches();
  before_.clear();  // undo() cannot restore a state from before the restart, so these states are discarded.
  entered_ = 0;
  last_line_ = place.restart.at.line;
  note_variables(0);
  lane_->placement = place.placement;
  lane_->start_over();
  lane_->on.origin = place.restart.at;
  lane_->on.work = place.restart.stand.work, lane_->on.machine = place.restart.stand.machine, lane_->on.placement = lane_->placement;
  lane_->on.modes = std::make_shared<PanelModes>(PanelModes{place.restart.in_force, place.calls, session_->control().lathe_modes()});
  for (const OtherChannelState& channel : place.other_channels) set_other_channel(channel);
  return {};
}

/// Restores another channel to its state at the restart position. In this state the channel waits for other channels or continues with
/// them.
void PanelMachine::set_other_channel(const OtherChannelState& channel) {
  ChannelAxes& lane = *lanes_[channel.channel];
  lane.start_over();
  lane.placement = channel.placement;
  lane.on.origin = channel.restart.at;
  lane.on.work = channel.restart.stand.work, lane.on.machine = channel.restart.stand.machine, lane.on.placement = lane.placement;
  lane.on.modes = std::make_shared<PanelModes>(
      PanelModes{channel.restart.in_force, channel.calls, session_->channels()[channel.channel].control->lathe_modes()});
  lane.has_ended = channel.is_over;
  if (!channel.waits) return;
  // This leg of the channel has no motion; the following call of waits() ends it at the meeting with the other channels.
  begin_leg(channel.channel);
  session_->together().waits(channel.channel, *channel.waits);
  lane.go_on();
}

/// True if each other channel has executed as many blocks as at the restart position, and if the axis positions of each waiting channel are
/// the same as at the restart position.
bool PanelMachine::stand_as_in(const RestartPoint& place) const {
  for (const OtherChannelState& channel : place.other_channels) {
    const ChannelAxes& lane = *lanes_[channel.channel];
    const Control& control = *session_->channels()[channel.channel].control;
    if (control.blocks() - lane.entered != channel.blocks || control.meeting().has_value() != channel.waits.has_value() || channel.in_block)
      return false;
    const Axes at = lane.sample().machine;
    for (std::size_t a = 0; channel.waits && a < lane.axes.size() && a < max_axes; ++a)
      if (!(std::fabs(at[a] - channel.restart.stand.machine[a]) <= at_place)) return false;
  }
  return true;
}

}  // namespace kadr
