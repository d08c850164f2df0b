#pragma once
// --stock guess, --tools guess: executes the program once before the cut, to find a suitable blank and suitable tools. This file is used by
// cli/cut.

#include "cli/job/job.h"
#include "config/tools/tool_library.h"

namespace kadr::cli {

inline constexpr const char* guess_word = "guess";

/// Finds a blank if --stock is `guess`, and tools if --tools is `guess`, and prints them. Prints an error if no suitable ones are found.
///   options  `stock` receives the description of a solid, in the form in which a user types it
///   tools    receives the tools with which the program cuts
///   returns  false if the program cuts nothing, if the shape of a tool is unknown, or if the program cannot be read twice
bool guess_blank_and_tools(CutOptions& options, const Job& job, ToolLibrary& tools);

}  // namespace kadr::cli
