#pragma once
// The local variables of the programs that are being executed: of the main program, and of each call that has variables of its own. The
// debugger shows them for each call of the stack.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace kadr {

struct ControlDef;
class Snapshot;

struct LocalVariables {
  std::size_t depth = 0;  // number of calls and repetitions that were open when their program began; 0: the main program
  std::vector<std::pair<std::string, double>> values;  // those that have a value: "#1", "#<depth>", "WIDTH"; mm, degrees or plain numbers
};

/// Returns the local variables at a snapshot, outermost first; empty if the control has no local variables.
std::vector<LocalVariables> local_variables(const Snapshot& snapshot, const ControlDef& def);

}  // namespace kadr
