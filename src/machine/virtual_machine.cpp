#include "machine/virtual_machine.h"

#include <algorithm>

#include "base/tolerance.h"
#include "motion/estimate.h"

namespace kadr {

VirtualMachine::VirtualMachine(const std::vector<std::string>& axes, AxisMask rotary, const MachineProfile& profile, const Setup& setup,
                               const ToolPosition& start)
    : names_(axes), roles_(AxisRoles::of(axes, rotary)), probe_(axes, roles_, setup), position_(start) {
  for (std::size_t i = 0; i < roles_.count; ++i) {
    const auto [least, most] = limits_of(profile, setup, axes[i]);
    least_[i] = least - tol::same_point;
    most_[i] = most + tol::same_point;
  }
}

tl::unexpected<Alarm> VirtualMachine::beyond(std::size_t axis, double machine) const {
  const double limit = machine < least_[axis] ? least_[axis] + tol::same_point : most_[axis] - tol::same_point;
  return fail(alarm(AlarmId::limit_exceeded, {}, std::string_view(names_[axis]), machine, limit));
}

Status VirtualMachine::check(const Motion& motion) const {
  for (std::size_t i = 0; i < roles_.count; ++i) {
    const double to = motion.machine[i], from = position_.machine[i];
    if ((to > most_[i] && to > from) || (to < least_[i] && to < from)) [[unlikely]]
      return beyond(i, to);
  }
  const bool curved = is_arc(motion.kind) || (motion.detail && motion.detail->surface == PathSurface::polar);
  return curved ? check_curve(motion) : Status{};
}

Status VirtualMachine::check_curve(const Motion& motion) const {
  const Extents box = machine_extents(roles_, position_, motion);
  for (std::size_t i = 0; i < roles_.count; ++i) {
    const double from = position_.machine[i], least = box.least[i], most = box.most[i];
    if (most > most_[i] && most > from + tol::same_point) return beyond(i, most);
    if (least < least_[i] && least < from - tol::same_point) return beyond(i, least);
  }
  return {};
}

bool VirtualMachine::has_limits() const {
  constexpr double none = 1e299;  // AxisProfile: ±1e300 is no limit
  for (std::size_t a = 0; a < roles_.count; ++a)
    if (least_[a] > -none || most_[a] < none) return true;
  return false;
}

Status VirtualMachine::take(const Action& action) {
  if (const auto* motion = std::get_if<Motion>(&action.what)) {
    KADR_TRY(check(*motion));
    position_.take(*motion);
  } else if (const auto* frame = std::get_if<FrameChange>(&action.what)) {
    position_.take(*frame);
  }
  return {};
}

ProbeAnswer VirtualMachine::probe(const Motion& motion) const { return probe_.meet(position_.work, motion.to); }

void end_at(Motion& motion, const ProbeAnswer& answer, const FrameRotation* rotation) {
  const Axes before = turned(rotation, motion.to), now = turned(rotation, answer.at);
  for (std::size_t i = 0; i < max_axes; ++i) motion.machine[i] += now[i] - before[i];
  motion.to = answer.at;
}

}  // namespace kadr
