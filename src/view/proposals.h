#pragma once
// Proposes the tools that a program seems to be written for, from the tools files next to it, its set-up and its comments. A person must
// check the proposals.

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
  std::string from;    // description of where that was found
  bool known = false;  // the shape is known; else the user must enter it
};

/// A tools file that was read.
struct KnownTools {
  std::string file;
  ToolLibrary tools;
};

/// Numbers of the tools that the program cuts with; 0 for a program that calls none.
std::vector<std::uint32_t> tools_cutting(const ProgramRun& run);

/// The file that describes all tools that the program cuts with: the only such file, or that with the name of the program, or "tools".
///   returns  nullptr if there is none
const KnownTools* tools_file_for(const std::vector<KnownTools>& files, const ProgramRun& run);

/// One tool for each number that the program cuts with, in the order of use. `file`: is searched first; nullptr: none.
std::vector<ProposedTool> proposed_tools(const ProgramRun& run, const KnownTools* file);

/// Radius of each of these tools by number, mm; 0 if unknown.
std::function<double(std::uint32_t tool)> radii_of(const std::vector<ProposedTool>& tools);

/// True if the part rotates and the tool turns: the control has no Y, or arcs are in the plane of a lathe.
bool is_turning(const ProgramRun& run);

}  // namespace kadr
