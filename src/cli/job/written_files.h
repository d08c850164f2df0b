#pragma once
// Files that the part program itself writes (--files): creates their folder, reports them if --files is missing, and lists the files that
// the program has read and that must not be overwritten.

#include <string>
#include <vector>

#include "cli/job/job.h"

namespace kadr::cli {

/// Creates the folder for the files that the part program writes. Its parent folder must exist.
bool make_folder(const std::string& folder);

/// Reports which files the part program would have written. Without --files it writes none.
void print_unwritten(const Options& options, const std::vector<Channel>& channels);

/// Returns the files that the run has read in addition to the program. Output files must not overwrite these files either.
std::vector<std::string> files_read(const std::vector<Channel>& channels);

}  // namespace kadr::cli
