// PanelMachine, what only a real machine has: faults, homing, a page that must stay alive, axes that others can move. Used by
// panel/panel_machine; tested by tests/panel/panel_grbl_test.cpp.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "panel/panel_machine.h"
#include "texts/grbl_machine.h"
#include "texts/panel.h"

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
  begin_really();
  return true;
}

PanelMachine::Answer PanelMachine::probe(const std::string& axis, double distance, double feed) {
  return ask([this, axis, distance, feed]() -> Answer {
    if (const Answer may = may_begin(); !may) return may;
    constexpr double farthest_touch = 1000, fastest_touch = 2000;  // mm, mm/min
    if (!(std::fabs(distance) <= farthest_touch) || distance == 0 || !(feed > 0 && feed <= fastest_touch))
      return Failed(translated(texts::grbl_machine::touch_limits, farthest_touch, fastest_touch));
    const Control& control = session_->control();
    if (control.in_block() || control.meeting()) return Failed(translated(texts::panel::run_block_first));
    const auto found = std::find(lane_->axes.begin(), lane_->axes.end(), axis);
    const std::size_t a = std::size_t(found - lane_->axes.begin());
    if (found == lane_->axes.end() || a > 2) return Failed(translated(texts::panel::no_such_axis, axis));
    lane_->pending = lane_->on;
    lane_->pending.machine = lane_->sample().machine;
    lane_->pending.machine[a] += distance;
    if (!lane_->begin_probe(a, lane_->pending.machine[a], feed)) return Failed(translated(texts::grbl_machine::no_probe));
    probed_axis_ = a;
    panel_state_.message.clear(), panel_state_.why.clear();
    notify("probe", axis, 0);
    begin_really();
    return {};
  });
}

/// The axes have passed the point where the probe has touched, while they slowed down: they go back to it.
void PanelMachine::go_to_touch() {
  const std::size_t axis = *std::exchange(probed_axis_, std::nullopt);
  const auto at = lane_->touched();
  if (!at) return;
  panel_state_.message = translated(texts::grbl_machine::touched, lane_->axes[axis], fmt::format("{:.3f}", (*at)[axis]));
  constexpr double back = 100;  // mm/min
  PanelPath path{own_, {}};
  WayPoint& point = path.points.emplace_back();
  point.rapid = false, point.feed = back;
  point.named = AxisMask{1} << axis;
  point.machine = *at;
  match_paths(path);
}

/// A run that the machine executes by itself: a held key, or a probe motion.
void PanelMachine::begin_really() {
  PanelRun& run = running_.emplace();
  run.of = Run::Of::hand;
  run.planned_all = true;
  has_moved_ = true;
  play();
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
