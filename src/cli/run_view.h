#pragma once
// View: observes one channel of a run. It collects statistics, and writes the trace, the picture and the data for the planner if the
// options request them.

#include <functional>
#include <memory>
#include <optional>

#include "cli/job/job.h"
#include "out/picture/plot/plot.h"
#include "out/text/summary.h"
#include "out/trace/trace.h"
#include "session/planned.h"

namespace kadr::cli {

struct View {
  View(const Channel& channel, const Rates& rates);

  /// Processes a step when the machine executes it. For motions that are still in the look-ahead, the programmed time is used.
  void show(const Step& step);

  /// Processes a step whose real time on the machine is known.
  ///   longer  additional time of the step compared with the programmed time, s
  void show_timed(const Step& step, double longer);

  /// Returns the function that observes the programmed motions, without cutter compensation; empty if no output needs them.
  std::function<void(const Action&)> programmed();

  Statistics statistics;
  std::optional<TraceWriter> trace;
  std::optional<Plot> plot;    // the picture; it exists only for the channel that runs the program itself
  Planned* planned = nullptr;  // the plan, only for the channel that runs the program itself; nullptr: no plan
  double waited = 0;           // time that the channel has waited for other channels, s
};

}  // namespace kadr::cli
