#pragma once
// Passes the commands of the machine's logic (machine/plc) to the controls of its channels.

#include <span>
#include <vector>

#include "control/control.h"
#include "machine/plc.h"

namespace kadr {

/// Signals, switches and spindles belong to the machine: all channels receive them (INFERRED). An answer goes to the channel that asked.
void apply(const std::vector<PlcCommand>& commands, Control& from, std::span<Control* const> channels);

}  // namespace kadr
