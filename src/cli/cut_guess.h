#pragma once
// --stock guess, --tools guess: guesses the blank and the tools of a program by executing it once before it is cut. Used by cli/cut.

#include "cli/job.h"
#include "config/tool_library.h"

namespace kadr::cli {

inline constexpr const char* guess_word = "guess";

/// Replaces each of the two that is to be guessed by the result, and prints it; complains on errors.
///   options  its stock becomes a body as the user could have written it
///   tools    get the tools that the program cuts with
///   returns  false if nothing is cut, a tool's shape is not known, or the program cannot be read twice
bool guess_blank_and_tools(CutOptions& options, const Job& job, ToolLibrary& tools);

}  // namespace kadr::cli
