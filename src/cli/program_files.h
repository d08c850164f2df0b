#pragma once
// The programs that a command is to look at: files as named, and those of folders that look like programs.

#include <string>
#include <vector>

namespace kadr::cli {

/// What cannot be read is kept with the reason, in the system's words.
struct Unreadable {
  std::string path, reason;
};

struct ProgramFiles {
  std::vector<std::string> files;  // as named; of a folder sorted, folder by folder
  std::vector<Unreadable> unreadable;
};

/// Of a folder and what is below it: every file with an ending that programs have, and those without one (O1001) whose text looks like a
/// program. Hidden files and folders are left out, links to folders are not followed.
///   exclude  patterns (* ? [abc]) of paths from the folder, or of names, that are left out
ProgramFiles program_files(const std::vector<std::string>& names, const std::vector<std::string>& exclude);

/// Its ending is one that programs have, or it has none.
bool has_program_name(const std::string& path);

}  // namespace kadr::cli
