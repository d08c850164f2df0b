#pragma once
// Passes the commands of the machine's logic (machine/plc) to the controls of its channels.

#include <span>
#include <vector>

#include "control/control.h"
#include "machine/plc.h"

namespace kadr {

/// Executes commands of the machine's logic on the controls of the channels. Signals, switches and spindles belong to the machine, so the
/// control of every channel receives them (INFERRED). An answer goes only to `from`, the control that asked the question.
void apply(const std::vector<PlcCommand>& commands, Control& from, std::span<Control* const> channels);

}  // namespace kadr
