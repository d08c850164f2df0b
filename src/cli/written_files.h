#pragma once
// What a program itself writes (--files): its folder, what it would have written, and the files that it has read and must not overwrite.

#include <string>
#include <vector>

#include "cli/job.h"

namespace kadr::cli {

/// Makes the folder for what the program writes, if only the last part of its path is missing.
bool make_folder(const std::string& folder);

/// Reports what a program would have written: without --files it writes nothing.
void tell_unwritten(const Options& options, const std::vector<Channel>& channels);

/// Returns the files that the run has read besides the program; they must not be overwritten either.
std::vector<std::string> files_read(const std::vector<Channel>& channels);

}  // namespace kadr::cli
