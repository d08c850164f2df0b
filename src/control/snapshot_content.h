#pragma once
// The contents of a snapshot. Only src/control includes this file.

#include <memory>

#include "control/emitter.h"
#include "control/state/snapshot.h"

namespace kadr {

/// The current block and its unfinished parts: a canned cycle, and functions that wait for the end of the cycle.
struct BlockMemory {
  Block block;
  std::string text;  // text of the block
  Plan plan;
  std::vector<std::uint8_t> waiting;  // functions of the block's plan, such as stops and ends, that wait for the end of the canned cycle
  CannedCycleRun canned_cycle_run;
  std::size_t cycle = 0;  // row of the cycle in ControlDef::cycles
  EllipseRun ellipse_run;
  std::shared_ptr<const SteppedCycle> running;
  RunPhase phase = RunPhase::next_block;
  AlarmReport report;  // the alarm that has stopped the control, if it is stopped
  // The values of block_exact, block_machine_coordinates and block_axes_taken of BlockContext.
  bool exact = false, machine_coordinates = false, axes_taken = false;
};

struct Snapshot::Content {
  ControlState state;
  RunMemory run;
  Flow::Memory flow;
  std::shared_ptr<const Tables> tables;
  std::shared_ptr<const Variables::Values> variables;
  std::shared_ptr<const DialectState> dialect;  // state of the dialect; nullptr: the dialect stores no data between blocks
  std::shared_ptr<const BlockMemory> block;
  bool each_block = false;
  double cutting_seen_ms = 0;  // time in ms of the motions at feed so far, which Control stores, not the interpreter
};

}  // namespace kadr
