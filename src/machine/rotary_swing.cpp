// Finds rotary axes that turn far while the tip hardly moves. Used by session/channel_run; tested by tests/cases/nct/25-five-axes.cases.

#include "machine/rotary_swing.h"

#include <cmath>

namespace kadr {
namespace {

constexpr double stands = 1e-6;  // a tip whose path is shorter than this number of mm counts as not moving

/// Returns the rotary axis that turns farthest in the step, and the angle by which it turns.
RotarySwing farthest_of(const Step& step, const Motion& motion) {
  RotarySwing found;
  for (AxisMask left = step.from.space->rotary_axes(); left != 0; left &= left - 1) {
    const auto axis = static_cast<std::size_t>(__builtin_ctz(left));
    const bool rolls = motion.detail && (motion.detail->rolled >> axis & 1U) != 0;
    const double degrees = std::fabs(rolls ? motion.detail->travel[axis] : motion.machine[axis] - step.from.machine[axis]);
    if (degrees > found.degrees) found = {axis, degrees, 0};
  }
  return found;
}

}  // namespace

std::optional<RotarySwing> SingularityWatch::look(const Step& step) {
  const Motion* const motion = step.motion();
  if (motion == nullptr || !controls_tip(step.from, *motion) || motion->kind == MotionKind::rapid || motion->kind == MotionKind::home)
    return std::nullopt;
  RotarySwing whirl = farthest_of(step, *motion);
  whirl.tip_travel = step.curve().length();
  const bool before = swings_;
  swings_ = whirl.degrees >= least && whirl.tip_travel > stands && whirl.degrees > most * whirl.tip_travel;
  if (!swings_ || before || reported_ >= max_reported) return std::nullopt;
  ++reported_;
  return whirl;
}

}  // namespace kadr
