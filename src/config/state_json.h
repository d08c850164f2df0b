#pragma once
// What a run leaves behind, as JSON: `state` of the trace's last line (tests/golden/README.md).

#include <string>

#include "config/setup.h"

namespace kadr {

/// One object in the form of the set-up: tables as they are after the run, shifts, spindles, the tool, the switches.
///   offsets            only the rows that hold something but zeros
///   numbers            the shortest text that reads back as the same double; null for what is no number
///   tables.shifts      not printed: state.shifts are
///   what is empty      is left out, but tool and, of a spindle, everything it can always say
///   law                parse_setup(state_json(state)) gives the same tables
std::string state_json(const RunState& state);

}  // namespace kadr
