#pragma once
// The part of the memory that only the NCT has (spec/nct): tools, the electronic gearbox, coupled axes. All data are plain values, so a
// snapshot can copy them.

#include "control/nct/axes/coupling.h"
#include "control/nct/axes/drives.h"
#include "control/nct/settings.h"
#include "control/nct/tools/tools.h"

namespace kadr::nct {

/// State of the electronic gearbox (20.1).
struct Gear {
  bool on = false;
  double ratio = 0;  // revolutions of the table per revolution of the spindle
  double teeth = 0;
};

/// The state of the NCT that a block may change. An alarm restores it as a whole.
struct UndoableState {
  Gear gear;
};

/// All data of the NCT that a snapshot copies as plain values.
struct Memory {
  Settings settings;
  UndoableState state;
  ToolManagement tools;
  DataInput data_input;
  Couplings couplings;        // axes that follow a master axis
  Drives drives;              // exchanged, reversed, parked axes
  int axes_in_all = 0;        // number of axes in all channels
  bool counts_time = false;   // true: when set_time() was called last, the life of at least one tool was counted in time
  bool turned = false;        // true: when set_time() was called last, the main spindle was turning
  double tool_magazine = 10;  // variable #8400: number of the spindle or stand-by magazine whose tool the variables #8401 … describe
};

}  // namespace kadr::nct
