// Holes of drilling cycles. For session/checklist; tested by tests/checklist.py.

#include "session/checklist/hole_watch.h"

#include <cmath>

namespace kadr {

void HoleWatch::take(const Step& step, Advices& to) {
  if (const auto* const change = std::get_if<ToolChange>(&step.action.what)) {
    tool_ = change->tool;
    holes_.clear();
    return;
  }
  constexpr std::size_t most_holes = 20'000;
  const Motion* const motion = step.motion();
  if (motion == nullptr || !motion->of_cycle || motion->kind != MotionKind::feed || holes_.size() >= most_holes) return;
  const Ends ends(step.roles, step.from, *motion);
  if (!ends.down()) return;
  for (std::size_t axis = 0; axis < step.roles.count; ++axis)  // a turned part has other holes there
    if (step.roles.is_rotary(axis) && step.from.work[axis] != 0) return;
  const auto micrometres = [](double mm) { return std::llround(mm * 1000); };
  const auto& machine = motion->machine;  // a shift of the zero makes another hole
  const auto at = [&](int axis) { return axis < 0 ? 0.0 : machine[static_cast<std::size_t>(axis)]; };
  const auto& xyz = step.roles.xyz;
  const bool is_new =
      holes_.insert({micrometres(at(xyz[0])), micrometres(at(xyz[1])), micrometres(at(xyz[2])), motion->system, std::int64_t{tool_}}).second;
  if (!is_new) to.add(AlarmId::hole_twice, step.action.origin, 0, ends.to.x, ends.to.y);
}

}  // namespace kadr
