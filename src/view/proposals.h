#pragma once
// Proposes the tools for which a program was probably written. The evidence is the tools files next to the program, the set-up of the
// program and its comments. The user must check the proposals.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "config/tools/tool_library.h"
#include "view/program_run.h"
#include "view/stock_guess.h"

namespace kadr {

struct ProposedTool {
  ToolGeometry tool;
  std::string from;    // text that states the file or comment that describes the tool
  bool known = false;  // true if the shape of the tool is known; otherwise the user must enter the shape
  // true: an insert of the offset table (insert_of_offset). A cut of a turned part takes it from there by itself, row by row.
  bool by_offset = false;
};

/// A tools file that has been read.
struct KnownTools {
  std::string file;
  ToolLibrary tools;
};

/// Returns the numbers of the tools with which the program cuts; tool 0 for a program that calls no tool.
std::vector<std::uint32_t> tools_cutting(const ProgramRun& run);

/// Returns the file that describes all tools with which the program cuts; on a lathe's control together with the offset table. If several
/// files qualify, returns the file with the name of the program, or with the name "tools".
///   returns  nullptr if no file qualifies
const KnownTools* tools_file_for(const std::vector<KnownTools>& files, const ProgramRun& run);

/// Returns one tool for each number with which the program cuts, in the order of use. `file` is the tools file that is searched first;
/// nullptr: no file.
std::vector<ProposedTool> proposed_tools(const ProgramRun& run, const KnownTools* file);

/// Returns a function that returns the radius in mm of the tool with a given number; 0 if the radius is unknown.
std::function<double(std::uint32_t tool)> radii_of(const std::vector<ProposedTool>& tools);

/// Returns what the comments of the program and its set-up tell about its blank.
BlankHints blank_hints(const ProgramRun& run);

/// Returns true if the program was probably written for a lathe: the control is a lathe's or has no Y axis, or arcs are in the plane G18.
bool is_turning(const ProgramRun& run);

/// Returns true if the blank of the program is a cylinder about the axis Z.
bool turns_part(const ProgramRun& run, const StockGuess& guess);

}  // namespace kadr
