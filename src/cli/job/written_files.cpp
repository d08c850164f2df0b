// Files that the part program itself writes (--files): creates their folder, reports them if --files is missing, and lists the files that
// the program has read and that must not be overwritten. This file is used by cli/run.

#include "cli/job/written_files.h"

#include <fmt/core.h>

#include <cerrno>
#include <filesystem>

#include "cli/job/terminal.h"
#include "config/read_file.h"
#include "texts/job.h"

namespace kadr::cli {

bool make_folder(const std::string& folder) {
  std::error_code error;
  if (folder.empty() || std::filesystem::is_directory(folder, error)) return true;
  if (std::filesystem::create_directory(folder, error)) return true;
  complain(fmt::format("--files {}: {}", folder, errno_message(error ? error.value() : ENOTDIR)));
  return false;
}

void print_unwritten(const Options& options, const std::vector<Channel>& channels) {
  if (!options.files.empty() || options.quiet) return;
  WrittenFiles files;
  for (const Channel& channel : channels)
    for (const auto& [path, bytes] : channel.control->files_written()) files[path] += bytes;
  if (files.empty()) return;
  const Lang lang = language(options);
  complain(translated_in(lang, texts::job::would_write_files));
  constexpr std::size_t max_shown = 20;
  std::size_t shown = 0;
  for (const auto& [path, bytes] : files) {
    if (++shown > max_shown) break;
    write_message(fmt::format("  {:<30} {}\n", path, counted_in(lang, texts::job::bytes, bytes)));
  }
  if (files.size() > max_shown) write_message(fmt::format("  … {}\n", files.size()));
}

std::vector<std::string> files_read(const std::vector<Channel>& channels) {
  std::vector<std::string> files;
  for (const Channel& channel : channels)
    for (std::string& file : channel.control->files_read()) files.push_back(std::move(file));
  return files;
}

}  // namespace kadr::cli
