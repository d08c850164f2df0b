// PanelMachine, what the operator does by hand: lines, and axes moved by a distance or as long as a key is held. Used by
// panel/panel_machine; tested by tests/panel/panel_by_hand_test.cpp.

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "panel/panel_machine.h"
#include "texts/grbl_machine.h"
#include "texts/panel.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;

}  // namespace

PanelMachine::Answer PanelMachine::enter(const std::string& line) {
  if (line.empty() || line.size() > max_entered || line.find_first_of("\n\r") != std::string::npos)
    return Failed(translated(texts::panel::one_line_wanted));
  return ask([this, line]() -> Answer {
    if (const Answer may = may_begin(); !may) return may;
    if (session_->control().in_block() || (goes_on_ && !stepping_->next())) return Failed(translated(texts::panel::run_block_first));
    auto memory = stepping_->snapshot();
    if (!memory) return Failed(translated(texts::panel::waits_for_probe));
    if (before_.size() == most_undone) before_.erase(before_.begin());
    before_.push_back({std::move(*memory), lane_->sample().machine, lane_->placement, entered_});
    panel_state_.message.clear(), panel_state_.why.clear();
    panel_state_.alarm.reset();
    notify("line", line);
    begin_line(line, own_);
    return {};
  });
}

PanelMachine::Answer PanelMachine::undo() {
  return ask([this]() -> Answer {
    if (const Answer may = may_begin(); !may) return may;
    if (is_real()) return Failed(translated(texts::grbl_machine::no_undo));
    if (before_.empty()) return Failed(translated(texts::panel::nothing_entered));
    const Before before = std::move(before_.back());
    before_.pop_back();
    const Setup tables = session_->control().tables_now();
    if (const Status back = stepping_->restore(before.stepping); !back) return Failed(std::string(name_of(back.error().id)));
    lane_->stand_at(before.machine);
    lane_->placement = before.placement;
    entered_ = before.entered;
    note_variables(0);
    keep_tables(tables);
    panel_state_.mode = stepping_->next() || goes_on_ ? PanelMode::standing : PanelMode::ended;
    panel_state_.alarm.reset();
    lane_->on.origin = stepping_->next().value_or(Origin()), lane_->on.entered = false;
    lane_->on.work = session_->stand().work, lane_->on.machine = before.machine, lane_->on.placement = lane_->placement;
    lane_->on.modes = std::make_shared<PanelModes>(PanelModes{session_->control().in_force(), {}, session_->control().lathe_modes()});
    return {};
  });
}

/// Returns the index of a channel by its number, 0: the program's own channel.
tl::expected<std::size_t, std::string> PanelMachine::channel_of(int number) const {
  if (number == 0) return own_;
  const auto found = std::find_if(lanes_.begin(), lanes_.end(), [number](const auto& lane) { return lane->number == number; });
  if (found == lanes_.end()) return Failed(translated(texts::panel::no_such_channel));
  return std::size_t(found - lanes_.begin());
}

PanelMachine::Answer PanelMachine::jog(const std::string& axis, double distance, double feed, int channel) {
  return ask([this, axis, distance, feed, channel]() -> Answer {
    if (const Answer may = may_begin(); !may) return may;
    const auto index = channel_of(channel);
    return index ? move_by_hand(*index, axis, distance, feed) : Answer(Failed(index.error()));
  });
}

PanelMachine::Answer PanelMachine::jog_while_held(const std::string& axis, double sign, double feed, int channel) {
  return ask([this, axis, sign, feed, channel]() -> Answer {
    if (const Answer may = may_begin(); !may) return may;
    if (!(std::fabs(sign) > 0) || !(feed >= 0)) return Failed(translated(texts::panel::way_and_feed_wanted));
    const auto index = channel_of(channel);
    if (!index) return Failed(index.error());
    const double distance = way_while_held(*index, axis, sign, feed);
    if (std::fabs(distance) < tol::same_point) return Failed(translated(texts::panel::beyond_end, axis));
    if (!jog_really(*index, axis, distance, feed))
      if (const Answer moves = move_by_hand(*index, axis, distance, feed); !moves) return moves;
    held_until_ = std::chrono::steady_clock::now() + most_silence;
    return {};
  });
}

bool PanelMachine::keep_jogging(bool on) {
  return ask(
             [this, on]() -> Answer {
               if (!held_until_ || lets_go_) return Failed(std::string());
               if (on) held_until_ = std::chrono::steady_clock::now() + most_silence, lane_->keep_jogging();
               else let_go();
               return {};
             },
             Wait::for_end)
      .has_value();
}

/// The axis that a held key moves slows down; watch_run() ends its motion when it stands.
void PanelMachine::let_go() {
  held_until_.reset();
  lets_go_ = true;
  apply_overrides();
}

}  // namespace kadr
