#pragma once
// ServedFolder: the only folder from which the page may read, and in which the page may save. The kernel resolves names beneath the folder
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
  Kind kind = Kind::other;  // kind of the file, which its name decides; if the name is not sufficient, its contents decide
  std::uint64_t size = 0;
  std::int64_t modified = 0;  // time of the last change, in s since 1970
};

struct FolderList {
  std::vector<FolderEntry> entries;  // entries sorted by name: first the folders, then the files
  bool more = false;                 // true if the folder has more than max_entries entries
};

/// A file in the trash.
struct TrashEntry {
  std::string trash;         // its place in the trash, for ServedFolder::restore()
  std::string file;          // the name that it had, relative to the served folder
  std::uint64_t size = 0;    // bytes
  std::int64_t deleted = 0;  // when it was deleted, s since 1970; 0: not known
};

struct TrashList {
  std::vector<TrashEntry> entries;  // the file that was deleted last comes first
  bool more = false;                // true if there are more than max_entries
};

/// Identifies the contents of a file. If the digest of a file differs from its digest at an earlier reading, the file has been changed or
/// replaced.
using FileDigest = std::string;

struct FileText {
  std::string bytes;
  FileDigest digest;
};

class ServedFolder : public FileAccess {
 public:
  static constexpr std::size_t max_entries = 10'000;
  static constexpr const char* trash_folder = ".kadr-trash";
  static constexpr std::size_t max_saved = std::size_t{16} << 20;  // greatest size of a saved file, bytes

  /// Opens a folder to serve it.
  ///   returns  the folder, or an error sentence if `path` is not a folder or cannot be read
  static tl::expected<ServedFolder, std::string> open(const std::string& path);
  ServedFolder(ServedFolder&& other) noexcept;
  ServedFolder& operator=(ServedFolder&&) = delete;
  ~ServedFolder() override;

  /// Returns the last component of the folder's path, for display.
  const std::string& name() const { return name_; }
  /// Returns a path of the file system as it is displayed: relative to the folder, if the file is beneath the folder.
  std::string shown(const std::string& path) const { return path.starts_with(path_ + "/") ? path.substr(path_.size() + 1) : path; }
  /// Lists a folder. `folder` is a relative path with '/'; an empty path means the served folder itself. Links, devices and names that
  /// begin with a dot are omitted.
  tl::expected<FolderList, std::string> list(const std::string& folder) const;
  /// Returns the path in the file system of a regular file beneath the folder, for code that reads programs and the files that they call.
  ///   returns  an error sentence if `file` is not a regular file, is outside the folder, or its name begins with a dot
  tl::expected<std::string, std::string> path_of(const std::string& file) const;
  /// Opens a file. The same files can be opened as with path_of() and read(): only programs, set-ups, tools and related files, and never a
  /// key file, whatever its name.
  ///   path     a path that path_of() has returned, or that a program derives from such a path
  ///   returns  a file descriptor; −1 on an error, with the errno EACCES if the file is not beneath the folder
  int open_for_reading(const std::string& path) const override;
  bool reaches(const std::string& path) const override { return beneath(path).has_value(); }
  tl::expected<FileText, std::string> read(const std::string& file, std::size_t most) const;
  /// Returns the digest of a file. The digest of a long file depends only on the file's size and the time of its last change. If these are
  /// those of the digest `known`, the file is not read.
  tl::expected<FileDigest, std::string> digest(const std::string& file, const FileDigest& known = "") const;

  struct Refused {
    std::string text;
    bool changed = false;  // true if the file has been changed after the page read it
  };
  /// Saves a file: writes the text to a new file in the same folder, and renames this file when all data are on the disk.
  ///   replaces  digest that the replaced file must have; nullopt: no file of this name may exist
  ///   returns   digest of the saved file
  tl::expected<FileDigest, Refused> save(const std::string& file, std::string_view text, const std::optional<FileDigest>& replaces) const;

  // ---- in folder_changes.cpp; Refused::changed: a file of the new name exists
  /// Gives a file another name, or moves it to another folder. A file is never replaced.
  tl::expected<void, Refused> rename(const std::string& file, const std::string& to) const;
  /// Copies a file of up to max_copied bytes under a new name.
  tl::expected<FileDigest, Refused> duplicate(const std::string& file, const std::string& to) const;
  /// Moves a file to the trash, the hidden folder `.kadr-trash` in the served folder.
  ///   returns  a name for restore()
  tl::expected<std::string, Refused> remove(const std::string& file) const;
  /// Moves a file from the trash to the place where it was.
  tl::expected<void, Refused> restore(const std::string& trash, const std::string& file) const;
  // ---- in folder_trash.cpp
  /// Lists the files in the trash. A missing trash is an empty one.
  tl::expected<TrashList, std::string> trash() const;
  /// Deletes files in the trash for good. What others have put into the folder of the trash stays there.
  ///   only     the place of one file (TrashEntry::trash); empty: all
  ///   returns  how many files were deleted
  tl::expected<std::size_t, Refused> empty_trash(const std::string& only) const;
  /// Creates a folder, unless it exists.
  tl::expected<void, Refused> make_folder(const std::string& folder) const;
  static constexpr std::size_t max_copied = std::size_t{64} << 20;

 private:
  ServedFolder(int fd, std::string path, std::string name) : fd_(fd), path_(std::move(path)), name_(std::move(name)) {}
  std::optional<std::string> beneath(const std::string& path) const;

  int fd_;
  std::string path_, name_;
};

/// Returns true for names of the folders in the trash in which removed files are: 20261129-162500-2.
bool is_place_in_trash(const std::string& name);

/// Returns the kind of a file; only the name of the file decides.
FolderEntry::Kind kind_of_file(std::string_view name);

}  // namespace kadr
