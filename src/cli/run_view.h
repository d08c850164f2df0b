#pragma once
// View: observes one channel of a run: its statistics, and trace, picture and planner if requested.

#include <functional>
#include <memory>
#include <optional>

#include "cli/job.h"
#include "out/picture/plot.h"
#include "out/text/summary.h"
#include "out/trace/trace.h"
#include "session/planned.h"

namespace kadr::cli {

struct View {
  View(const Channel& channel, const Rates& rates);

  /// Shows a step when the machine executes it. The time of motions still in the look-ahead counts as programmed.
  void show(const Step& step);

  /// Shows a step with the machine's time for it.
  void show_timed(const Step& step, double longer);

  /// Returns the observer of motions as programmed, before compensation; empty if nothing needs them.
  std::function<void(const Action&)> programmed();

  Statistics statistics;
  std::optional<TraceWriter> trace;
  std::optional<Plot> plot;    // of the program's own channel
  Planned* planned = nullptr;  // of the program's own channel
  double waited = 0;           // s
};

}  // namespace kadr::cli
