#pragma once
// Identity of files: finds out whether two paths lead to the same file, also through symbolic or hard links.

#include <compare>
#include <cstdint>
#include <optional>
#include <set>
#include <string>

namespace kadr {

struct FileId {
  std::uint64_t device = 0;
  std::uint64_t number = 0;  // inode number
  auto operator<=>(const FileId&) const = default;
};

/// Returns the identity of the file that the path leads to, after resolving links; nullopt if the file does not exist.
std::optional<FileId> file_id_of(const std::string& path);
/// Returns the identity of an open file.
std::optional<FileId> file_id_of(int descriptor);

/// Returns the absolute path with every link resolved, including a link in the last component. The file need not exist.
std::string true_path(const std::string& path);

/// A set of files, given by their paths. A file that does not exist yet can be an element of the set.
class FileSet {
 public:
  void add(const std::string& path);
  void add(FileId id) { ids_.insert(id); }
  bool has(const std::string& path) const;
  bool has(FileId id) const { return ids_.contains(id); }

 private:
  std::set<FileId> ids_;
  std::set<std::string> paths_;  // paths of the files, with links resolved by true_path()
};

}  // namespace kadr
