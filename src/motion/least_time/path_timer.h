#pragma once
// PathTimer: the speed along a path in cells: by the quick solver (motion/least_time/primal_dual), else by the sure one.

#include "motion/least_time/least_time.h"
#include "motion/least_time/primal_dual.h"

namespace kadr {

class PathTimer {
 public:
  ///   returns  false: no speed was found that obeys the limits; or `stop` asked it to end
  bool solve(const TimedPath& path, const PathEnds& ends, StopToken stop = {});

  /// Of the last path that it found a speed for.
  const std::vector<CellSpeeds>& speeds() const { return *speeds_; }
  const std::vector<double>& middles() const { return *middles_; }
  /// What it has done so far.
  struct Work {
    std::size_t paths = 0, cells = 0;
    double steps = 0;             // of the quick solver, each over all cells
    std::size_t by_sure_one = 0;  // paths for which the quick one found none
  };
  const Work& work() const { return work_; }

 private:
  bool take(const std::vector<CellSpeeds>& speeds, const std::vector<double>& middles);

  PrimalDual quick_;
  LeastTime sure_;
  LeastTime sure_to_limits_{LimitMargins{1.003, 1.003}};  // goes on from a speed that is nearer to them than its own margins
  const std::vector<CellSpeeds>* speeds_ = nullptr;
  const std::vector<double>* middles_ = nullptr;
  Work work_;
};

}  // namespace kadr
