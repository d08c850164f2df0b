// DogLeg: computes rapid motions of axes that move independently. It is used by session/cutting/tool_path and axes_path, and tested by
// tests/run_cut.py.

#include "session/cutting/dog_leg.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr double same_part = 1e-9;  // arrival times, as fractions (0 to 1) of the motion's time, that differ by less count as equal

bool is_rapid(const Motion& motion) { return motion.kind == MotionKind::rapid || (motion.kind == MotionKind::home && !(motion.feed > 0)); }

}  // namespace

std::optional<DogLeg> DogLeg::of(const Step& step, const std::optional<Axes>& rates) {
  const Motion* const motion = step.motion();
  if (!rates || motion == nullptr || !is_rapid(*motion) || controls_tip(step.from, *motion)) return std::nullopt;
  DogLeg leg;
  double longest = 0;
  for (std::size_t i = 0; i < step.roles.count; ++i) {
    const bool rolls = motion->detail && (motion->detail->rolled >> i & 1U) != 0;
    const double travel = rolls ? motion->detail->travel[i] : motion->machine[i] - step.from.machine[i];
    leg.arrives_[i] = (*rates)[i] > 0 ? std::fabs(travel) / (*rates)[i] : 0;
    longest = std::max(longest, leg.arrives_[i]);
  }
  if (!(longest > 0)) return leg;
  for (double& arrives : leg.arrives_) {
    arrives /= longest;
    if (arrives > same_part) leg.corners_.push_back(arrives);
  }
  std::sort(leg.corners_.begin(), leg.corners_.end());
  const auto same = [](double a, double b) { return b - a < same_part; };
  leg.corners_.erase(std::unique(leg.corners_.begin(), leg.corners_.end(), same), leg.corners_.end());
  leg.corners_.back() = 1;
  return leg;
}

}  // namespace kadr
