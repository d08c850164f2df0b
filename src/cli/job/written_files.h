#pragma once
// Files that a program itself writes (--files): their folder, the report without --files, and the files that the program has read and
// must not overwrite.

#include <string>
#include <vector>

#include "cli/job/job.h"

namespace kadr::cli {

/// Creates the folder for the files that the program writes, if its parent folder exists.
bool make_folder(const std::string& folder);

/// Reports which files the program would have written: without --files it writes none.
void print_unwritten(const Options& options, const std::vector<Channel>& channels);

/// Returns the files that the run has read besides the program; output files must not overwrite them either.
std::vector<std::string> files_read(const std::vector<Channel>& channels);

}  // namespace kadr::cli
