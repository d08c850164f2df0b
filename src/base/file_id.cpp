// Identity of files: decides whether two paths lead to the same file. Used for the outputs of a command (out/trace/result_file,
// cli/job/outputs) and of a program (control/macro_b/output/output_file); tested by tests/base/file_id_test.cpp.

#include "base/file_id.h"

#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <memory>

namespace kadr {
namespace {

std::optional<std::string> real_path(const std::string& path) {
  const std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr), &std::free);
  return real ? std::optional<std::string>(real.get()) : std::nullopt;
}

std::optional<FileId> id_of(int done, const struct stat& there) {
  if (done != 0) return std::nullopt;
  return FileId{static_cast<std::uint64_t>(there.st_dev), static_cast<std::uint64_t>(there.st_ino)};
}

}  // namespace

std::optional<FileId> file_id_of(const std::string& path) {
  struct stat there {};
  return id_of(::stat(path.c_str(), &there), there);
}

std::optional<FileId> file_id_of(int descriptor) {
  struct stat there {};
  return id_of(::fstat(descriptor, &there), there);
}

std::string true_path(const std::string& path) {
  namespace fs = std::filesystem;
  constexpr int max_links = 40;  // greatest number of links that are followed: the limit of the operating system
  fs::path at(path);
  for (int i = 0; i < max_links; ++i) {
    if (const auto real = real_path(at.string())) return *real;
    std::error_code error;
    // The path may be a link to a file that does not exist yet, so the target of the link is read here.
    const fs::path target = fs::read_symlink(at, error);
    if (error) break;
    at = target.is_absolute() ? target : at.parent_path() / target;
  }
  const auto folder = real_path(at.has_parent_path() ? at.parent_path().string() : ".");
  return folder ? (fs::path(*folder) / at.filename()).string() : at.string();
}

void FileSet::add(const std::string& path) {
  if (const auto id = file_id_of(path)) ids_.insert(*id);
  paths_.insert(true_path(path));
}

bool FileSet::has(const std::string& path) const {
  if (ids_.empty() && paths_.empty()) return false;
  const auto id = file_id_of(path);
  return (id && ids_.contains(*id)) || paths_.contains(true_path(path));
}

}  // namespace kadr
