// PanelMachine, what only a real machine has: faults, homing, a page that must stay alive, axes that others can move. Used by
// panel/panel_machine; tested by tests/panel/panel_grbl_test.cpp.

#include <algorithm>
#include <cmath>

#include "panel/panel_machine.h"
#include "texts/grbl_machine.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;

}  // namespace

/// Notices a fault of the machine, which ends the run, and a page that is no longer alive, which holds it.
void PanelMachine::watch_machine() {
  const std::string fault = lane_->fault();
  const bool is_known =
      panel_state_.mode == PanelMode::emergency || (panel_state_.mode == PanelMode::alarm && panel_state_.message == fault);
  if (!fault.empty() && !is_known) {
    drop_run();
    retables_.reset();
    panel_state_.mode = PanelMode::alarm;
    panel_state_.message = fault;
    notify("alarm", fault, lane_->on.origin.line);
    show();
    return;
  }
  using Clock = std::chrono::steady_clock;
  const Clock::time_point alive(Clock::duration(alive_at_.load()));
  if (running_ && !holds_ && alive_at_ != 0 && Clock::now() - alive > lease) {
    holds_ = true;
    panel_state_.message = translated(texts::grbl_machine::page_lost, std::chrono::duration_cast<std::chrono::seconds>(lease).count());
    notify("hold", panel_state_.message, lane_->on.origin.line);
    apply_overrides();
  }
  follow_machine();
  if (!running_) show();
}

/// If the axes were moved by something else, by homing or by hand, the control continues from where they are.
void PanelMachine::follow_machine() {
  const Control& control = session_->control();
  if (running_ || retables_ || control.in_block() || control.meeting() || is_in_contour() || !lane_->stands()) return;
  const Axes at = lane_->sample().machine, stand = session_->stand().machine;
  double off = 0;
  for (std::size_t a = 0; a < lane_->axes.size() && a < max_axes; ++a) off = std::max(off, std::fabs(at[a] - stand[a]));
  if (!(off > lane_->nearly_there())) return;
  session_->stand_at(at);
  lane_->on.work = session_->stand().work, lane_->on.machine = at;
}

/// Moves an axis of a real machine while a key is held. Returns false if the machine is virtual.
bool PanelMachine::jog_really(std::size_t channel, const std::string& axis, double distance, double feed) {
  ChannelAxes& lane = *lanes_[channel];
  const auto found = std::find(lane.axes.begin(), lane.axes.end(), axis);
  if (!lane.is_real() || found == lane.axes.end()) return false;
  const std::size_t a = std::size_t(found - lane.axes.begin());
  lane.pending = lane.on;
  lane.pending.machine = lane.sample().machine;
  lane.pending.machine[a] += distance;
  if (!lane.begin_jog(a, lane.pending.machine[a], feed)) return false;
  PanelRun& run = running_.emplace();
  run.of = Run::Of::hand;
  run.planned_all = true;
  has_moved_ = true;
  play();
  return true;
}

PanelMachine::Answer PanelMachine::home() {
  return ask([this]() -> Answer {
    if (running_) return Failed(translated(texts::grbl_machine::not_idle, lane_->real() ? lane_->real()->state : std::string()));
    notify("home");
    if (!lane_->home()) return Failed(translated(texts::grbl_machine::virtual_machine));
    return {};
  });
}

PanelMachine::Answer PanelMachine::unlock() {
  return ask([this]() -> Answer {
    if (running_) return Failed(translated(texts::grbl_machine::not_idle, lane_->real() ? lane_->real()->state : std::string()));
    notify("unlock");
    if (!lane_->unlock()) return Failed(translated(texts::grbl_machine::virtual_machine));
    return {};
  });
}

}  // namespace kadr
