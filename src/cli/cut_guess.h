#pragma once
// --stock guess, --tools guess: what a program seems to be cut from, and with, by carrying it out once before it is cut. For cli/cut.

#include "cli/job.h"
#include "config/tool_library.h"

namespace kadr::cli {

inline constexpr const char* guess_word = "guess";

/// Takes for each of the two that is to be guessed what is found, and says what that is; complains.
///   options  its stock becomes a body, as it could have been written
///   tools    those that the program cuts with
///   returns  false: nothing is cut, a tool's shape is not known, the program cannot be read twice
bool guess_blank_and_tools(CutOptions& options, const Job& job, ToolLibrary& tools);

}  // namespace kadr::cli
