// PlannedTime divides the time of a least-time plan into cutting, rapid motion, dwell and tool change. Used by session/planned and
// out/text/summary.

#include "motion/time/planned_time.h"

#include <algorithm>

#include "motion/least_time/axis_motion.h"

namespace kadr {

void PlannedTime::take(const TimedCells& cells, const MotionLimits& limits) {
  constexpr double barely = 0.02;  // fraction of the acceleration limit below which the speed counts as constant
  const double least = barely * *std::min_element(limits.acceleration.begin(), limits.acceleration.end());
  for (std::size_t k = 0; k < cells.laws.size(); ++k) {
    const TimeLaw& law = cells.laws[k];
    const Spent::On on = Spent::of(cells.sources[k].tag).on;
    if (on == Spent::On::dwell) dwell += law.seconds;
    if (on == Spent::On::tool_change) tool_change += law.seconds;
    if (on != Spent::On::cutting && on != Spent::On::rapid) continue;
    Share& share = on == Spent::On::rapid ? rapid : cutting;
    share.all += law.seconds;
    const double gained = law.at(1).speed - law.at(0).speed;
    if (gained > least * law.seconds) share.speeding_up += law.seconds;
    if (-gained > least * law.seconds) share.slowing_down += law.seconds;
  }
}

}  // namespace kadr
