#pragma once
// What a program itself writes (--files): its folder, what it would have written, what it has read and must not write over.

#include <string>
#include <vector>

#include "cli/job.h"

namespace kadr::cli {

/// The folder for what the program writes: made, if only its last part is missing.
bool make_folder(const std::string& folder);

/// Without --files a program writes nothing: what it would have written.
void tell_unwritten(const Options& options, const std::vector<Channel>& channels);

/// What the run has read besides the program must not be written over either.
std::vector<std::string> files_read(const std::vector<Channel>& channels);

}  // namespace kadr::cli
