#pragma once
// Finds the programs that a command processes: the files named on the command line, and files in the named folders that look like
// programs.

#include <string>
#include <vector>

namespace kadr::cli {

/// A file that cannot be read, with the operating system's error message.
struct Unreadable {
  std::string path, reason;
};

struct ProgramFiles {
  std::vector<std::string> files;  // paths; the files of a folder are sorted, folders are in the order of the command line
  std::vector<Unreadable> unreadable;
};

/// Searches folders and their subfolders. Returns every file with a file name extension of programs, and files without an extension
/// (O1001) whose text looks like a program. Hidden files and folders are left out; links to folders are not followed.
///   exclude  patterns (* ? [abc]) of names, or of paths relative to the folder, that are left out
ProgramFiles program_files(const std::vector<std::string>& names, const std::vector<std::string>& exclude);

/// True if the file name has an extension of programs, or no extension.
bool has_program_name(const std::string& path);

}  // namespace kadr::cli
