#pragma once
// What looks at one channel of a run: its statistics, and the trace, picture and planner that were asked for.

#include <functional>
#include <memory>
#include <optional>

#include "cli/job.h"
#include "session/planned.h"
#include "motion/look_ahead/look_ahead.h"
#include "out/picture/plot.h"
#include "out/text/summary.h"
#include "out/trace/trace.h"

namespace kadr::cli {

struct View {
  View(const Channel& channel, const Rates& rates);

  /// Of a channel alone: several wait for each other by their programmed times, and their speeds are not planned.
  void begin_look_ahead(const Channel& channel, const Rates& rates, const MachineProfile& profile);

  /// To the statistics and the trace. The time of what the look-ahead holds counts as programmed; another tool, only when all motions of
  /// the one before are through.
  void show(const Step& step);

  /// To whoever draws, before who times what is drawn.
  void look(const Step& step);

  /// Takes the motions as programmed, before compensation; empty: nobody looks.
  std::function<void(const Action&)> programmed();

  Statistics statistics;
  std::optional<TraceWriter> trace;
  std::optional<LookAhead> look_ahead;  // where something limits the speed
  std::optional<Plot> plot;             // of the program's own channel
  std::unique_ptr<Planned> planned;     // of the program's own channel
  double waited = 0;                    // s
};

}  // namespace kadr::cli
