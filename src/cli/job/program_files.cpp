// Finds the programs in folders. This file is used by cli/check and tested by tests/run_check.py.

#include "cli/job/program_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "base/ascii.h"
#include "config/control/guess.h"
#include "config/program_names.h"
#include "config/read_file.h"
#include "lang/text/utf16.h"

namespace kadr::cli {
namespace {

namespace fs = std::filesystem;

bool looks_like_program(const std::string& path) {
  auto source = open_text(path).source;
  if (!source) return false;
  LineReader reader(std::move(source));
  return is_program_text(reader.sample());
}

bool is_program(const fs::path& path) {
  const NameVerdict verdict = judge_name(path.string());
  return verdict == NameVerdict::nothing ? looks_like_program(path.string()) : verdict == NameVerdict::program;
}

/// Searches folders one after the other in a loop. Recursion is not used, since deeply nested folders could exceed the stack.
class Search {
 public:
  Search(const std::vector<std::string>& exclude, ProgramFiles& found) : exclude_(exclude), found_(found) {}

  void folder(const fs::path& root) {
    std::vector<fs::path> open{root};
    while (!open.empty()) {
      const fs::path folder = std::move(open.back());
      open.pop_back();
      look(root, folder, open);
    }
  }

 private:
  void look(const fs::path& root, const fs::path& folder, std::vector<fs::path>& open) {
    std::error_code error;
    std::vector<fs::path> files, folders;
    fs::directory_iterator entry(folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
      const fs::path& path = entry->path();
      if (path.filename().string().starts_with('.') || is_left_out(path.lexically_relative(root).string())) continue;
      std::error_code of_entry;
      const bool folder_there = fs::is_directory(entry->symlink_status(of_entry));
      const bool file_there = !of_entry && !folder_there && fs::is_regular_file(entry->status(of_entry));
      if (folder_there) folders.push_back(path);
      else if (file_there) files.push_back(path);
      else if (of_entry && of_entry != std::errc::no_such_file_or_directory)
        found_.unreadable.push_back({path.string(), errno_message(of_entry.value())});
    }
    if (error) found_.unreadable.push_back({folder.string(), errno_message(error.value())});
    std::sort(files.begin(), files.end());
    // the list is sorted in descending order, since the last folder of the list is searched next
    std::sort(folders.rbegin(), folders.rend());
    for (const fs::path& file : files)
      if (is_program(file)) found_.files.push_back(file.string());
    open.insert(open.end(), folders.begin(), folders.end());
  }

  bool is_left_out(const std::string& path) const {
    return std::any_of(exclude_.begin(), exclude_.end(), [&](const std::string& pattern) { return is_like(path, pattern); });
  }

  const std::vector<std::string>& exclude_;
  ProgramFiles& found_;
};

}  // namespace

bool has_program_name(const std::string& path) { return judge_name(path) != NameVerdict::other; }

ProgramFiles program_files(const std::vector<std::string>& names, const std::vector<std::string>& exclude) {
  ProgramFiles found;
  Search search(exclude, found);
  for (const std::string& name : names) {
    std::error_code error;
    if (fs::is_directory(name, error)) search.folder(name);
    else found.files.push_back(name);
  }
  return found;
}

}  // namespace kadr::cli
