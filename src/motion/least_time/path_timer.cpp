// PathTimer finds the speed along a path in cells, with the fast solver or the reliable solver. Used by motion/least_time/planner.

#include "motion/least_time/path_timer.h"

namespace kadr {

bool PathTimer::take(const std::vector<CellSpeeds>& speeds, const std::vector<double>& middles) {
  speeds_ = &speeds;
  middles_ = &middles;
  return true;
}

bool PathTimer::solve(const TimedPath& path, const PathEnds& ends, StopToken stop) {
  if (path.cells() < least_cells) return false;
  ++work_.paths;
  work_.cells += path.cells();
  const bool found = quick_.solve(path, ends, stop);
  work_.steps += quick_.steps();
  if (found) return take(quick_.speeds(), quick_.middles());
  ++work_.by_sure_one;
  for (LeastTime* const sure : {&sure_, &sure_to_limits_})
    if (!stop.requested() && sure->solve(path, ends, stop)) return take(sure->speeds(), sure->middles());
  return false;
}

}  // namespace kadr
