#pragma once
// What a snapshot holds. Only src/control includes it.

#include <memory>

#include "control/dialect.h"
#include "control/flow/flow.h"
#include "control/state/run_memory.h"
#include "control/state/snapshot.h"
#include "control/state/state.h"
#include "control/variables/variables.h"

namespace kadr {

struct Snapshot::Content {
  ControlState state;
  RunMemory run;
  Flow::Memory flow;
  std::shared_ptr<const Tables> tables;
  std::shared_ptr<const Variables::Values> variables;
  std::shared_ptr<const DialectState> dialect;  // nullptr: the control has none
  double cutting_seen_ms = 0;                   // of Control
};

}  // namespace kadr
