// Finds rotary axes that turn far while the tip hardly moves. Used by session/channel_run; tested by tests/cases/nct/25-five-axes.cases.

#include "machine/whirl.h"

#include <cmath>

namespace kadr {
namespace {

constexpr double stands = 1e-6;  // mm; on a shorter path the tip counts as standing still

/// Returns the rotary axis that turns farthest in the step, and its rotation.
Whirl farthest_of(const Step& step, const Motion& motion) {
  Whirl found;
  for (AxisMask left = step.from.space->rotary_axes(); left != 0; left &= left - 1) {
    const auto axis = static_cast<std::size_t>(__builtin_ctz(left));
    const bool rolls = motion.detail && (motion.detail->rolled >> axis & 1U) != 0;
    const double degrees = std::fabs(rolls ? motion.detail->travel[axis] : motion.machine[axis] - step.from.machine[axis]);
    if (degrees > found.degrees) found = {axis, degrees, 0};
  }
  return found;
}

}  // namespace

std::optional<Whirl> WhirlWatch::look(const Step& step) {
  const Motion* const motion = step.motion();
  if (motion == nullptr || !leads_tip(step.from, *motion) || motion->kind == MotionKind::rapid || motion->kind == MotionKind::home)
    return std::nullopt;
  Whirl whirl = farthest_of(step, *motion);
  whirl.way = step.curve().length();
  const bool before = whirls_;
  whirls_ = whirl.degrees >= least && whirl.way > stands && whirl.degrees > most * whirl.way;
  if (!whirls_ || before || told_ >= most_told) return std::nullopt;
  ++told_;
  return whirl;
}

}  // namespace kadr
