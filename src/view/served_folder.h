#pragma once
// ServedFolder: the only folder that the page may read and save to. The kernel resolves names beneath it (openat2), so that no path leads
// out of it, by dots, links or mounts of /proc.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "base/file_door.h"

namespace kadr {

struct FolderEntry {
  enum class Kind : std::uint8_t { folder, program, setup, tools, other };
  std::string name;
  Kind kind = Kind::other;  // by its name; if that is not enough, by its contents
  std::uint64_t size = 0;
  std::int64_t modified = 0;  // s since 1970
};

struct FolderList {
  std::vector<FolderEntry> entries;  // folders first, by name
  bool more = false;                 // there are more than most_entries
};

/// Identifies the state of a file when it was read: if it differs now, the file has been replaced or changed.
using FileDigest = std::string;

struct FileText {
  std::string bytes;
  FileDigest digest;
};

class ServedFolder : public FileDoor {
 public:
  static constexpr std::size_t most_entries = 10'000;
  static constexpr std::size_t most_saved = std::size_t{16} << 20;  // bytes

  ///   returns  an error sentence if it is no folder, or cannot be read
  static tl::expected<ServedFolder, std::string> open(const std::string& path);
  ServedFolder(ServedFolder&& other) noexcept;
  ServedFolder& operator=(ServedFolder&&) = delete;
  ~ServedFolder() override;

  /// The last component of its path, for display.
  const std::string& name() const { return name_; }
  /// A path in the file system as displayed: relative to the folder if it is beneath it.
  std::string shown(const std::string& path) const { return path.starts_with(path_ + "/") ? path.substr(path_.size() + 1) : path; }
  /// `folder`: relative path with '/'; empty: the folder itself. Leaves out names that begin with a dot, links and devices.
  tl::expected<FolderList, std::string> list(const std::string& folder) const;
  /// The path in the file system of a regular file beneath the folder, for code that reads programs and the files they call.
  ///   returns  an error sentence if it is no regular file, leads out of the folder, or begins with a dot
  tl::expected<std::string, std::string> path_of(const std::string& file) const;
  /// Only programs, set-ups, tools and related files can be read, here as in path_of() and read(); never a key file, whatever its name.
  /// `path` is in the file system, as path_of() returns it and as programs derive paths from it; if it is not beneath the folder, the
  /// error is EACCES.
  int open_for_reading(const std::string& path) const override;
  bool reaches(const std::string& path) const override { return beneath(path).has_value(); }
  tl::expected<FileText, std::string> read(const std::string& file, std::size_t most) const;
  /// Digest of a file; for long files from size and time only.
  tl::expected<FileDigest, std::string> digest(const std::string& file) const;

  struct Refused {
    std::string text;
    bool changed = false;  // since the file was read
  };
  /// Writes to a new file in the same folder, and renames it once all data are on the disk.
  ///   replaces  the file to be replaced must have this digest; nullopt: it must not exist
  ///   returns   the new digest
  tl::expected<FileDigest, Refused> save(const std::string& file, std::string_view text, const std::optional<FileDigest>& replaces) const;

 private:
  ServedFolder(int fd, std::string path, std::string name) : fd_(fd), path_(std::move(path)), name_(std::move(name)) {}
  std::optional<std::string> beneath(const std::string& path) const;

  int fd_;
  std::string path_, name_;
};

/// The kind of a file by its name.
FolderEntry::Kind kind_of_file(std::string_view name);

}  // namespace kadr
