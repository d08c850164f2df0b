// VirtualMachine: moves the axes as the actions demand, checks axis limits and zones, and computes what probe motions touch. Used by
// session/channel_run; tested by tests/machine/virtual_machine_test.cpp.

#include "machine/virtual_machine.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "action/by_kind.h"
#include "action/take_actions.h"
#include "base/tolerance.h"
#include "motion/time/estimate.h"
#include "path/curve/machine_path.h"

namespace kadr {
namespace {

/// Returns false if the axis has no limits: AxisProfile states this by the values -1e300 and 1e300.
bool is_limit(double least, double most) {
  constexpr double none = 1e299;
  return least > -none || most < none;
}

/// Returns the distance by which the axis remains away from its commanded position. The set-up's entry for the axis takes precedence over
/// its entry for all axes.
double position_error(const Setup& setup, const std::string& axis) {
  for (const std::string& name : {axis, std::string("*")})
    if (const auto found = setup.machine.find(name); found != setup.machine.end()) return found->second.position_error;
  return 0;
}

/// Returns true if a machine that never refuses a motion only has to update its position: no probe touches anything, and no safety zone
/// changes. `has_zones`: other actions than motions may change the zones.
bool only_moves(const ActionBatch& batch, bool has_zones) {
  return std::all_of(batch.begin(), batch.end(), [&](const Action& action) {
    const auto* const motion = motion_of(action);
    return motion != nullptr ? motion->kind != MotionKind::probe : !has_zones;
  });
}

}  // namespace

VirtualMachine::VirtualMachine(const std::vector<std::string>& axes, AxisMask rotary, const MachineProfile& profile, const Setup& setup,
                               const ToolPosition& start)
    : names_(axes), roles_(AxisRoles::of(axes, rotary)), probe_(axes, roles_, setup), position_(start) {
  for (std::size_t i = 0; i < roles_.count; ++i) {
    std::tie(least_[i], most_[i]) = limits_of(profile, setup, axes[i]);
    if (is_limit(least_[i], most_[i])) limited_ |= AxisMask{1} << i;
  }
}

void VirtualMachine::limit(std::size_t axis, double least, double most) {
  if (axis >= roles_.count || (limited_ >> axis & 1U) != 0 || !is_limit(least, most)) return;
  limited_ |= AxisMask{1} << axis;
  least_[axis] = least;
  most_[axis] = most;
}

void VirtualMachine::obey_parameters(const Setup& setup) {
  zones_.emplace(names_, roles_, Extents{least_, most_}, setup);
  const MachineParameters parameters = machine_parameters(setup, names_);
  never_in_position_ = 0;
  for (std::size_t i = 0; i < roles_.count; ++i)
    if (std::abs(position_error(setup, names_[i])) > parameters.in_position[i]) never_in_position_ |= AxisMask{1} << i;
  for (AxisMask left = parameters.gantry; left != 0; left &= left - 1) {
    const auto axis = static_cast<std::size_t>(__builtin_ctz(left));
    watch_gantry(setup, axis, parameters.gantry_master[axis]);
  }
}

/// Checks a gantry axis, which two drives move (nct 20.6). INFERRED: the manual gives no number for the parameter of the limit, so the
/// set-up states the limit. The positions of the two drives always differ by the difference of their position errors in the set-up.
void VirtualMachine::watch_gantry(const Setup& setup, std::size_t axis, std::size_t master) {
  const auto found = setup.machine.find(names_[axis]);
  if (found == setup.machine.end() || !found->second.apart || apart_) return;
  const double apart = std::abs(position_error(setup, names_[axis]) - position_error(setup, names_[master]));
  if (!(apart > *found->second.apart + tol::same_point)) return;
  apart_ = alarm(AlarmId::gantry_apart, {}, std::string_view(names_[axis]), apart, *found->second.apart);
  gantry_ = AxisMask{1} << axis | AxisMask{1} << master;
}

tl::unexpected<Alarm> VirtualMachine::beyond(std::size_t axis, double machine) const {
  return fail(
      alarm(AlarmId::limit_exceeded, {}, std::string_view(names_[axis]), machine, machine < least_[axis] ? least_[axis] : most_[axis]));
}

Status VirtualMachine::check(const Motion& motion) const {
  if (zones_) return zones_->check(position_, motion);
  if (limited_ == 0) return {};
  for (std::size_t i = 0; i < roles_.count; ++i) {
    const double to = motion.machine[i], from = position_.machine[i];
    if ((to > most_[i] + tol::same_point && to > from) || (to < least_[i] - tol::same_point && to < from)) [[unlikely]]
      return beyond(i, to);
  }
  const bool curved = is_arc(motion.kind) || motion.kind == MotionKind::spline ||
                      (motion.detail && motion.detail->surface == PathSurface::polar) || controls_tip(position_, motion);
  return curved ? check_curve(motion) : Status{};
}

Status VirtualMachine::check_curve(const Motion& motion) const {
  if (controls_tip(position_, motion)) {
    const Curve curve(roles_, position_.work, motion);
    const Extents rough = MachinePath(roles_, position_, motion, curve).rough_extents();
    bool within = true;
    for (std::size_t i = 0; i < roles_.count; ++i) within = within && rough.least[i] >= least_[i] && rough.most[i] <= most_[i];
    if (within) return {};
  }
  const Extents box = machine_extents(roles_, position_, motion);
  for (std::size_t i = 0; i < roles_.count; ++i) {
    const double from = position_.machine[i], least = box.least[i], most = box.most[i];
    if (most > std::max(most_[i], from) + tol::same_point) return beyond(i, most);
    if (least < std::min(least_[i], from) - tol::same_point) return beyond(i, least);
  }
  return {};
}

bool VirtualMachine::has_limits() const {
  if (never_in_position_ != 0 || apart_ || (zones_ && zones_->in_force())) return true;
  return limited_ != 0;
}

Status VirtualMachine::take(const Action& action) {
  missing_ = 0;
  gantry_moved_ = false;
  if (const auto* motion = motion_of(action)) {
    KADR_TRY(check(*motion));
    for (std::size_t i = 0; motion->in_position && i < roles_.count; ++i)
      if (motion->machine[i] != position_.machine[i]) missing_ |= never_in_position_ & AxisMask{1} << i;
    for (std::size_t i = 0; apart_ && i < roles_.count; ++i)
      gantry_moved_ = gantry_moved_ || ((gantry_ >> i & 1U) != 0 && motion->machine[i] != position_.machine[i]);
    position_.take(*motion);
    return {};
  }
  position_.take(action);
  if (const auto* const zone = std::get_if<ZoneChange>(&action.what); zone != nullptr && zones_) zones_->change(*zone);
  return {};
}

VirtualMachine::Outcome VirtualMachine::take(ActionBatch& batch, Follows follows, const OnTouch& on_touch) {
  // Number of actions that belong to earlier blocks: short motions are stored so that they can be joined with later ones (path/smooth)
  const std::size_t of_before = compression_.take(batch, position_.work, follows == Follows::nothing);
  Outcome outcome;
  if (hung_ == 0 && !has_limits() && only_moves(batch, zones_.has_value())) [[likely]] {
    missing_ = 0;
    gantry_moved_ = false;
    take_actions(position_, batch.begin(), batch.end());
    outcome.done = batch.size();
    return outcome;
  }
  ToolPosition before = position_;
  for (Action& action : batch) {
    if (outcome.done == of_before) before = position_;
    Status status = execute(action, on_touch);
    outcome.refused = !status;
    if (status) {
      ++outcome.done;
      status = in_position();
    }
    if (status) continue;
    outcome.alarm = status.error();
    outcome.origin = action.origin;
    break;
  }
  if (!outcome.refused) return outcome;
  if (outcome.done >= of_before) position_ = before;
  // Actions of the refused block do not count as executed, but those of earlier blocks do
  outcome.done = std::min(outcome.done, of_before);
  compression_.drop();
  return outcome;
}

Status VirtualMachine::execute(Action& action, const OnTouch& on_touch) {
  auto* const motion = motion_of(action);
  if (motion != nullptr && hung_ != 0) leave_hung(*motion);
  if (motion == nullptr || motion->kind != MotionKind::probe) return take(action);
  if (zones_ && zones_->checks_before()) KADR_TRY(check(*motion));
  const ProbeAnswer answer = probe(*motion);
  end_at(*motion, answer, position_.turn.get());
  KADR_TRY(take(action));
  on_touch(answer);
  return {};
}

Status VirtualMachine::in_position() const {
  if (gantry_moved_) return fail(*apart_);
  if (missing_ == 0) [[likely]]
    return {};
  return fail(alarm(AlarmId::position_error, {}, std::string_view(names_[static_cast<std::size_t>(__builtin_ctz(missing_))])));
}

/// Replaces the end position of an axis that follows another channel by the axis' present position. The control may not know the present
/// position yet.
void VirtualMachine::leave_hung(Motion& motion) const {
  for (std::size_t i = 0; i < roles_.count; ++i) {
    if ((hung_ >> i & 1U) == 0) continue;
    motion.to[i] += position_.machine[i] - motion.machine[i];
    motion.machine[i] = position_.machine[i];
  }
}

Status VirtualMachine::follow(const Axes& work, const Axes& machine, AxisMask moved) {
  Motion motion;
  motion.kind = MotionKind::feed;
  motion.named = moved;
  motion.to = position_.work;
  motion.machine = position_.machine;
  for (std::size_t i = 0; i < roles_.count; ++i)
    if ((moved >> i & 1U) != 0) motion.to[i] = work[i], motion.machine[i] = machine[i];
  KADR_TRY(check(motion));
  position_.work = motion.to;
  position_.machine = motion.machine;
  return {};
}

void VirtualMachine::exchange(std::size_t axis, VirtualMachine& with, std::size_t other) {
  std::swap(names_[axis], with.names_[other]);
  std::swap(least_[axis], with.least_[other]);
  std::swap(most_[axis], with.most_[other]);
  const bool has = (limited_ >> axis & 1U) != 0, had = (with.limited_ >> other & 1U) != 0;
  limited_ = had ? limited_ | AxisMask{1} << axis : limited_ & ~(AxisMask{1} << axis);
  with.limited_ = has ? with.limited_ | AxisMask{1} << other : with.limited_ & ~(AxisMask{1} << other);
  if (zones_ && with.zones_) zones_->exchange(axis, *with.zones_, other);
}

VirtualMachine::Memory VirtualMachine::memory() const {
  return {position_, missing_, compression_.memory(), zones_ ? std::optional(zones_->memory()) : std::nullopt};
}

void VirtualMachine::resume_from(const Memory& memory) {
  position_ = memory.position;
  missing_ = memory.missing;
  compression_.resume_from(memory.compression);
  if (zones_ && memory.zones) zones_->resume_from(*memory.zones);
}

void VirtualMachine::set_signal(std::string_view name, bool on) {
  if (zones_ && name == "CP_LIM2DIS") zones_->suspend(2, on);
  if (zones_ && name == "CP_LIM3DIS") zones_->suspend(3, on);
}

ProbeAnswer VirtualMachine::probe(const Motion& motion) const {
  const int input = motion.detail ? motion.detail->input : 0;
  Axes to = motion.to;
  for (std::size_t i = 0; i < roles_.count && motion.detail; ++i)
    if ((motion.detail->rolled >> i & 1U) != 0) to[i] = position_.work[i] + motion.detail->travel[i];
  ProbeAnswer answer = probe_.meet(position_.work, to, input);
  if (!answer.touched) answer.at = motion.to;
  return answer;
}

void end_at(Motion& motion, const ProbeAnswer& answer, const FrameTurn* turn) {
  const Axes before = turned(turn, motion.to), now = turned(turn, answer.at);
  const AxisMask parked = motion.detail ? motion.detail->parked : 0;
  for (std::size_t i = 0; i < max_axes; ++i)
    if ((parked >> i & 1U) == 0) motion.machine[i] += now[i] - before[i];
  motion.to = answer.at;
  if (!motion.detail || answer.part == 1) return;
  auto detail = std::make_shared<MotionDetail>(*motion.detail);
  for (double& travel : detail->travel) travel *= answer.part;
  detail->flat_to = detail->flat_from + answer.part * (detail->flat_to - detail->flat_from);
  motion.detail = std::move(detail);
}

}  // namespace kadr
