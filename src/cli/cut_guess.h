#pragma once
// --stock guess, --tools guess: finds a blank and tools that suit a program by running it once before it is cut. Used by cli/cut.

#include "cli/job/job.h"
#include "config/tools/tool_library.h"

namespace kadr::cli {

inline constexpr const char* guess_word = "guess";

/// Replaces --stock guess and --tools guess by what it finds, and prints it; prints an error if that fails.
///   options  its stock becomes the description of a body, as a user could have typed it
///   tools    gets the tools with which the program cuts
///   returns  false if the program cuts nothing, a tool's shape is not known, or the program cannot be read twice
bool guess_blank_and_tools(CutOptions& options, const Job& job, ToolLibrary& tools);

}  // namespace kadr::cli
