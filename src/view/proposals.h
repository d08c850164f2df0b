#pragma once
// Proposes the tools for which a program seems to be written. The evidence is the tools files next to the program, its set-up and its
// comments. A person must check the proposals.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "config/tools/tool_library.h"
#include "view/program_run.h"

namespace kadr {

struct ProposedTool {
  ToolGeometry tool;
  std::string from;    // text that says in which file or comment the tool was found
  bool known = false;  // the shape of the tool is known; false: the user must enter it
};

/// A tools file that has been read.
struct KnownTools {
  std::string file;
  ToolLibrary tools;
};

/// Returns the numbers of the tools with which the program cuts; tool 0 for a program that calls no tool.
std::vector<std::uint32_t> tools_cutting(const ProgramRun& run);

/// Returns the file that describes all tools with which the program cuts. If several files do, returns the one that has the name of the
/// program, or is named "tools".
///   returns  nullptr if no file qualifies
const KnownTools* tools_file_for(const std::vector<KnownTools>& files, const ProgramRun& run);

/// Returns one tool for each number with which the program cuts, in the order of use. `file`: tools file that is searched first; nullptr:
/// none.
std::vector<ProposedTool> proposed_tools(const ProgramRun& run, const KnownTools* file);

/// Returns a function that gives the radius of a tool by its number, mm; 0 if the radius is unknown.
std::function<double(std::uint32_t tool)> radii_of(const std::vector<ProposedTool>& tools);

/// True if the program seems to be for turning, where the part rotates: the control has no Y axis, or arcs are in the plane of a lathe.
bool is_turning(const ProgramRun& run);

}  // namespace kadr
