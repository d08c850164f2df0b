#pragma once
// What a snapshot holds. Only src/control includes it.

#include <memory>

#include "control/emitter.h"
#include "control/state/snapshot.h"

namespace kadr {

/// The current block, and what stands open of it: a cycle, what waits for its end.
struct BlockMemory {
  Block block;
  std::string text;  // of the block
  Plan plan;
  std::vector<std::uint8_t> waiting;  // items of the plan
  CycleRun cycle_run;
  std::size_t cycle = 0;  // row of it
  EllipseRun ellipse_run;
  std::shared_ptr<const Running> running;
  RunPhase phase = RunPhase::next_block;
  AlarmReport report;                                                   // of a control that has stopped
  bool exact = false, machine_coordinates = false, axes_taken = false;  // of Interpreter
};

struct Snapshot::Content {
  ControlState state;
  RunMemory run;
  Flow::Memory flow;
  std::shared_ptr<const Tables> tables;
  std::shared_ptr<const Variables::Values> variables;
  std::shared_ptr<const DialectState> dialect;  // nullptr: it remembers nothing
  std::shared_ptr<const BlockMemory> block;
  bool each_block = false;
  double cutting_seen_ms = 0;  // of Control
};

}  // namespace kadr
