#pragma once
// Finds the programs for a command: the files named, and those files in the named folders that look like programs.

#include <string>
#include <vector>

namespace kadr::cli {

/// A file that cannot be read, and the reason in the system's words.
struct Unreadable {
  std::string path, reason;
};

struct ProgramFiles {
  std::vector<std::string> files;  // as named; files of a folder are sorted, folder by folder
  std::vector<Unreadable> unreadable;
};

/// Searches folders and their subfolders: returns every file with an ending that programs have, and files without one (O1001) whose text
/// looks like a program. Hidden files and folders are left out, links to folders are not followed.
///   exclude  patterns (* ? [abc]) of paths from the folder, or of names, that are left out
ProgramFiles program_files(const std::vector<std::string>& names, const std::vector<std::string>& exclude);

/// True if the name has an ending that programs have, or none.
bool has_program_name(const std::string& path);

}  // namespace kadr::cli
