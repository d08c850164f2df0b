#pragma once
// Tools that a program seems to be written for: by the tools files beside it, its set-up, its comments. Proposals, to be looked at by a
// person.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "config/tool_library.h"
#include "view/program_run.h"

namespace kadr {

struct ProposedTool {
  ToolGeometry tool;
  std::string from;    // where that was found: told
  bool known = false;  // its shape is; else it must be given
};

/// A tools file that was looked into.
struct KnownTools {
  std::string file;
  ToolLibrary tools;
};

/// Numbers of the tools that the program cuts with; of one that calls none, 0.
std::vector<std::uint32_t> tools_cutting(const ProgramRun& run);

/// The file that describes all tools that the program cuts with: the only one, or that which is called as the program, or "tools".
///   returns  nullptr: none
const KnownTools* tools_file_for(const std::vector<KnownTools>& files, const ProgramRun& run);

/// A tool for each number that the program cuts with, in the order of their use. `file`: which is asked first; nullptr: none.
std::vector<ProposedTool> proposed_tools(const ProgramRun& run, const KnownTools* file);

/// mm of each of these tools, by its number, as far as its size is known; 0: it is not.
std::function<double(std::uint32_t tool)> radii_of(const std::vector<ProposedTool>& tools);

/// The part spins under a turning tool: the control has no Y, or arcs are those of a lathe.
bool is_turning(const ProgramRun& run);

}  // namespace kadr
