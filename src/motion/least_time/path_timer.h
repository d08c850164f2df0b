#pragma once
// PathTimer finds the speed along a path in cells with the fast solver (motion/least_time/primal_dual). If the fast solver fails, PathTimer
// uses the slow, reliable solver (motion/least_time/least_time).

#include "motion/least_time/least_time.h"
#include "motion/least_time/primal_dual.h"

namespace kadr {

class PathTimer {
 public:
  /// Computes the speeds along the path in all its cells; the result is in speeds().
  ///   returns  false if no speed was found that obeys the limits, or if `stop` ended the search
  bool solve(const TimedPath& path, const PathEnds& ends, StopToken stop = {});

  /// The speeds of the path that solve() solved last.
  const std::vector<CellSpeeds>& speeds() const { return *speeds_; }
  const std::vector<double>& middles() const { return *middles_; }
  /// Statistics of all paths since the object was created.
  struct Work {
    std::size_t paths = 0, cells = 0;
    double steps = 0;             // number of steps of the fast solver; one step covers all cells of a path
    std::size_t by_sure_one = 0;  // number of paths that the fast solver did not solve
  };
  const Work& work() const { return work_; }

 private:
  bool take(const std::vector<CellSpeeds>& speeds, const std::vector<double>& middles);

  PrimalDual quick_;
  LeastTime sure_;
  // The reliable solver with limits raised by 0.3 %. It is used for a start speed that is nearer to the limits than the default margins
  // allow.
  LeastTime sure_to_limits_{LimitMargins{1.003, 1.003}};
  const std::vector<CellSpeeds>* speeds_ = nullptr;
  const std::vector<double>* middles_ = nullptr;
  Work work_;
};

}  // namespace kadr
