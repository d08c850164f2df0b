#pragma once
// Which file a name means: two names of one file, by links of whatever kind, are told from names of two.

#include <compare>
#include <cstdint>
#include <optional>
#include <set>
#include <string>

namespace kadr {

struct FileId {
  std::uint64_t device = 0;
  std::uint64_t number = 0;  // of the inode
  auto operator<=>(const FileId&) const = default;
};

/// Links are followed. Nothing: there is no such file.
std::optional<FileId> file_id_of(const std::string& path);
/// Of an open file.
std::optional<FileId> file_id_of(int descriptor);

/// The path from the root with every link followed, that of the last part too; there need not be such a file.
std::string true_path(const std::string& path);

/// Some files: whether they are there already or not.
class FileSet {
 public:
  void add(const std::string& path);
  void add(FileId id) { ids_.insert(id); }
  bool has(const std::string& path) const;
  bool has(FileId id) const { return ids_.contains(id); }

 private:
  std::set<FileId> ids_;
  std::set<std::string> paths_;  // true ones
};

}  // namespace kadr
