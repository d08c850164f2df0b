#pragma once
// Prints the state after a run as JSON: the key `state` in the trace's last line (tests/golden/README.md).

#include <string>

#include "config/setup/setup.h"

namespace kadr {

/// Returns a JSON object in the form of a set-up: tables after the run, shifts, spindles, tool, switches.
///   offsets:           only rows with a value other than 0
///   numbers:           the shortest text that reads back as the same double; null for NaN and infinity
///   tables.shifts:     not printed; state.shifts is printed instead
///   empty values:      left out, except for `tool`, and for the values that every spindle has
///   law                parse_setup(state_json(state)) gives the same tables
std::string state_json(const RunState& state);

}  // namespace kadr
