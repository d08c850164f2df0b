#pragma once
// Formats the summary of a run as JSON for other programs. The JSON contains all numbers of the text summary (out/text/summary;
// docs/commands/run.md).

#include <string>
#include <vector>

#include "out/text/summary.h"

namespace kadr {

/// The data about one channel of a run.
struct ChannelSummary {
  int channel = 1;
  const Statistics* statistics = nullptr;
  std::uint64_t blocks = 0;
  double waited = 0;                     // s
  const PlannedTime* planned = nullptr;  // time that the least-time planner has computed; nullptr: the planner was not used
};

struct RunSummary {
  std::string program, control;  // name of the program file, id of the control
  bool complete = true;          // true: the program was executed to its end
  PlannerMode counts = PlannerMode::programmed;
  std::vector<ChannelSummary> channels;
};

/// Returns the JSON text, which ends in '\n'. Lengths are in mm, angles in degrees and times in s, independently of the program's unit.
std::string summary_json(const RunSummary& run);

}  // namespace kadr
