#pragma once
// What only the NCT remembers (spec/nct): tools, the gearbox, axes that hang on others. Values.

#include "control/nct/axes/coupling.h"
#include "control/nct/axes/drives.h"
#include "control/nct/settings.h"
#include "control/nct/tools/tools.h"

namespace kadr::nct {

/// The electronic gearbox (20.1).
struct Gear {
  bool on = false;
  double ratio = 0;  // revolutions of the table for one of the spindle
  double teeth = 0;
};

/// What a run remembers of it; an alarm brings it back as one value.
struct Volatile {
  Gear gear;
};

/// All of it that is a plain value: a snapshot copies it.
struct Memory {
  Settings settings;
  Volatile state;
  ToolManagement tools;
  DataInput data_input;
  Couplings couplings;        // axes that follow others
  Drives drives;              // exchanged, reversed, parked axes
  int axes_in_all = 0;        // of all channels
  bool counts_time = false;   // of tools, since set_time came last
  bool turned = false;        // the main spindle, then
  double tool_magazine = 10;  // #8400
};

}  // namespace kadr::nct
