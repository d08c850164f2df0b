#pragma once
// What the machine's logic (machine/plc) commands, carried to the controls of its channels.

#include <span>
#include <vector>

#include "control/control.h"
#include "machine/plc.h"

namespace kadr {

/// Signals, switches and spindles are the machine's: all channels see them (INFERRED). An answer goes to the channel that asked.
void apply(const std::vector<PlcCommand>& commands, Control& from, std::span<Control* const> channels);

}  // namespace kadr
