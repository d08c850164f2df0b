#pragma once
// Finds the programs that a command processes: the files that the command line names, and the files in named folders that look like
// programs.

#include <string>
#include <vector>

namespace kadr::cli {

/// A file that cannot be read, and the error message of the operating system.
struct Unreadable {
  std::string path, reason;
};

struct ProgramFiles {
  std::vector<std::string> files;  // paths of the files; within a folder they are sorted, and folders are in the order of the command line
  std::vector<Unreadable> unreadable;
};

/// Searches folders and their subfolders. Returns every file with a file name extension of programs, and every file without an extension
/// (O1001) whose text looks like a program. Hidden files and folders are omitted, and links to folders are not followed.
///   exclude  patterns (* ? [abc]) of the names, or of the paths relative to the folder, that are omitted
ProgramFiles program_files(const std::vector<std::string>& names, const std::vector<std::string>& exclude);

/// True if the file name has no extension or an extension of programs.
bool has_program_name(const std::string& path);

}  // namespace kadr::cli
