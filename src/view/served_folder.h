#pragma once
// ServedFolder: the only folder from which the page may read and in which it may save. The kernel resolves names beneath the folder
// (openat2), so that no path leaves the folder by dots, links or mounts of /proc.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "base/file_access.h"

namespace kadr {

struct FolderEntry {
  enum class Kind : std::uint8_t { folder, program, setup, tools, other };
  std::string name;
  Kind kind = Kind::other;  // kind of the file, judged by its name; if the name does not decide, by its contents
  std::uint64_t size = 0;
  std::int64_t modified = 0;  // time of the last change, s since 1970
};

struct FolderList {
  std::vector<FolderEntry> entries;  // folders first, then files, each sorted by name
  bool more = false;                 // the folder has more than max_entries entries
};

/// A digest identifies the contents of a file. If a file's digest is not the one from when the file was read, the file has been changed or
/// replaced.
using FileDigest = std::string;

struct FileText {
  std::string bytes;
  FileDigest digest;
};

class ServedFolder : public FileAccess {
 public:
  static constexpr std::size_t max_entries = 10'000;
  static constexpr std::size_t max_saved = std::size_t{16} << 20;  // maximum size of a saved file, bytes

  ///   returns  an error sentence if `path` is no folder or cannot be read
  static tl::expected<ServedFolder, std::string> open(const std::string& path);
  ServedFolder(ServedFolder&& other) noexcept;
  ServedFolder& operator=(ServedFolder&&) = delete;
  ~ServedFolder() override;

  /// The last component of the folder's path, for display.
  const std::string& name() const { return name_; }
  /// Returns a path of the file system as it is displayed: relative to the folder, if the file is beneath the folder.
  std::string shown(const std::string& path) const { return path.starts_with(path_ + "/") ? path.substr(path_.size() + 1) : path; }
  /// Lists a folder. `folder`: relative path with '/'; empty: the served folder itself. Names that begin with a dot, links and devices
  /// are omitted.
  tl::expected<FolderList, std::string> list(const std::string& folder) const;
  /// Returns the path in the file system of a regular file beneath the folder, for code that reads programs and the files that they call.
  ///   returns  an error sentence if `file` is no regular file, is outside the folder, or its name begins with a dot
  tl::expected<std::string, std::string> path_of(const std::string& file) const;
  /// Opens a file. Like path_of() and read(), it opens only programs, set-ups, tools and related files, and never a key file, whatever its
  /// name.
  ///   path     a path that path_of() has returned, or that a program derives from such a path
  ///   returns  a file descriptor; −1 on an error, with the errno EACCES if the file is not beneath the folder
  int open_for_reading(const std::string& path) const override;
  bool reaches(const std::string& path) const override { return beneath(path).has_value(); }
  tl::expected<FileText, std::string> read(const std::string& file, std::size_t most) const;
  /// Returns the digest of a file. The digest of a long file depends only on the file's size and the time of its last change.
  tl::expected<FileDigest, std::string> digest(const std::string& file) const;

  struct Refused {
    std::string text;
    bool changed = false;  // the file has been changed since it was read
  };
  /// Writes the text to a new file in the same folder, and renames that file when all data are on the disk.
  ///   replaces  digest that the replaced file must have; nullopt: no file of this name may exist
  ///   returns   digest of the saved file
  tl::expected<FileDigest, Refused> save(const std::string& file, std::string_view text, const std::optional<FileDigest>& replaces) const;

 private:
  ServedFolder(int fd, std::string path, std::string name) : fd_(fd), path_(std::move(path)), name_(std::move(name)) {}
  std::optional<std::string> beneath(const std::string& path) const;

  int fd_;
  std::string path_, name_;
};

/// Returns the kind of a file, judged by its name.
FolderEntry::Kind kind_of_file(std::string_view name);

}  // namespace kadr
