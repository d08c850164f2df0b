#pragma once
// Writes the summary of a run as JSON for programs: all numbers of the text summary (out/text/summary; docs/commands/run.md).

#include <string>
#include <vector>

#include "out/text/summary.h"

namespace kadr {

/// One channel of a run.
struct ChannelSummary {
  int channel = 1;
  const Statistics* statistics = nullptr;
  std::uint64_t blocks = 0;
  double waited = 0;                     // s
  const PlannedTime* planned = nullptr;  // nullptr: the planner of least time was not used
};

struct RunSummary {
  std::string program, control;  // the file's name, the control's id
  bool complete = true;          // the program was executed to its end
  PlannerMode counts = PlannerMode::programmed;
  std::vector<ChannelSummary> channels;
};

/// Returns lengths in mm, angles in degrees and times in s, whatever the program's unit. Ends in '\n'.
std::string summary_json(const RunSummary& run);

}  // namespace kadr
