#pragma once
// Planned: one channel's axes in time by the planner of least time (docs/planner.md), and whoever looks at it.

#include <cstdio>

#include "cli/channels.h"
#include "motion/axis_motion.h"
#include "out/samples.h"

namespace kadr::cli {

class Planned {
 public:
  /// `stand`: where the axes stand at the start.
  Planned(const Channel& channel, const Job& job, const ToolPosition& stand);
  Planned(const Planned&) = delete;  // the planner calls it back
  Planned& operator=(const Planned&) = delete;

  /// Positions at `rate` Hz; the file stays the caller's.
  void write_samples(std::FILE* file, double rate);

  /// An action of the program, behind the machine.
  void take(const Action& action);

  /// The axes come to rest. False: not all could be written.
  bool finish();

 private:
  void see(const TimedCells& cells);

  AxisRoles roles_;
  std::vector<std::string> axes_;
  ToolPosition position_;
  TimeEstimate estimate_;  // by programmed feeds
  std::optional<SampleWriter> writer_;
  AxisMotion motion_;
};

}  // namespace kadr::cli
