// HoleWatch: finds positions at which drilling cycles drill a hole twice. It is used by session/checklist and tested by tests/checklist.py.

#include "session/checklist/hole_watch.h"

#include <cmath>

namespace kadr {

void HoleWatch::take(const Step& step, Advices& to) {
  // After a tool change the new tool may drill the same hole again. After an auxiliary function (such as B90, which turns a table that the
  // control does not drive) a hole at the same position is another hole. So the recorded holes are dropped.
  if (std::holds_alternative<ToolChange>(step.action.what) || std::holds_alternative<AuxiliaryFunction>(step.action.what))
    return holes_.clear();
  constexpr std::size_t max_holes = 20'000;
  const Motion* const motion = step.motion();
  if (motion == nullptr || !motion->of_cycle || motion->kind != MotionKind::feed || holes_.size() >= max_holes) return;
  const Ends ends(step.roles, step.from, *motion);
  if (!ends.down()) return;
  // Holes are compared by their machine coordinates: if the work offset is shifted or the part is rotated between two holes, their work
  // coordinates may be equal although the holes are not the same.
  std::array<std::int64_t, max_axes + 1> hole{};
  for (std::size_t axis = 0; axis < step.roles.count; ++axis) hole[axis] = std::llround(motion->machine[axis] * 1000);
  hole.back() = motion->system;
  const bool is_new = holes_.insert(hole).second;
  if (!is_new) to.add(AlarmId::hole_twice, step.action.origin, 0, ends.to.x, ends.to.y);
}

}  // namespace kadr
