#pragma once
// What looks at one channel of a run: its statistics, and the trace, picture and planner that were asked for.

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

  /// As the machine takes it. The time of what the look-ahead holds counts as programmed.
  void show(const Step& step);

  /// In the machine's time.
  void show_timed(const Step& step, double longer);

  /// Takes the motions as programmed, before compensation; empty: nobody looks.
  std::function<void(const Action&)> programmed();

  Statistics statistics;
  std::optional<TraceWriter> trace;
  std::optional<Plot> plot;    // of the program's own channel
  Planned* planned = nullptr;  // of the program's own channel
  double waited = 0;           // s
};

}  // namespace kadr::cli
