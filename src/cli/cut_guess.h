#pragma once
// --stock guess, --tools guess: finds a blank and tools that suit a program by running it once before it is cut. Used by cli/cut.

#include "cli/job/job.h"
#include "config/tools/tool_library.h"

namespace kadr::cli {

inline constexpr const char* guess_word = "guess";

/// Where --stock or --tools is `guess`, stores the blank or the tools that suit the program, and prints them. Prints an error if none are
/// found.
///   options  `stock` is set to the description of a body, in the form in which a user types it
///   tools    is set to the tools with which the program cuts
///   returns  false if the program cuts nothing, a tool's shape is not known, or the program cannot be read twice
bool guess_blank_and_tools(CutOptions& options, const Job& job, ToolLibrary& tools);

}  // namespace kadr::cli
