#pragma once
// View: observes one channel of a run: collects statistics, and writes trace, plot and planner data if the options request them.

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

  /// Observes a step when the machine executes it. The time of motions that are still in the look-ahead counts as programmed.
  void show(const Step& step);

  /// Observes a step whose time on the machine is known.
  ///   longer  s by which the step takes longer than programmed
  void show_timed(const Step& step, double longer);

  /// Returns the function that observes motions as programmed, before cutter compensation; empty if nothing needs it.
  std::function<void(const Action&)> programmed();

  Statistics statistics;
  std::optional<TraceWriter> trace;
  std::optional<Plot> plot;    // the picture, only for the channel of the program itself
  Planned* planned = nullptr;  // the plan, only for the channel of the program itself
  double waited = 0;           // time that the channel waited for others, s
};

}  // namespace kadr::cli
