#pragma once
// ServedFolder: the one folder that the page may look into and save to. Names are resolved beneath it by the kernel (openat2): no way leads
// out, by dots, links or mounts of /proc.

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
  Kind kind = Kind::other;  // by its name; where that says nothing, by what stands in the file
  std::uint64_t size = 0;
  std::int64_t modified = 0;  // s since 1970
};

struct FolderList {
  std::vector<FolderEntry> entries;  // folders first, by name
  bool more = false;                 // there are above most_entries
};

/// What a file was when it was read: another one stands there, or it has been changed, if this differs.
using FileDigest = std::string;

struct FileText {
  std::string bytes;
  FileDigest digest;
};

class ServedFolder : public FileDoor {
 public:
  static constexpr std::size_t most_entries = 10'000;
  static constexpr std::size_t most_saved = std::size_t{16} << 20;  // bytes

  ///   returns  an error sentence: it is none, or cannot be read
  static tl::expected<ServedFolder, std::string> open(const std::string& path);
  ServedFolder(ServedFolder&& other) noexcept;
  ServedFolder& operator=(ServedFolder&&) = delete;
  ~ServedFolder() override;

  /// Its last part, as people call it.
  const std::string& name() const { return name_; }
  /// A path in the file system as people call it: from the folder on, where it lies beneath.
  std::string shown(const std::string& path) const { return path.starts_with(path_ + "/") ? path.substr(path_.size() + 1) : path; }
  /// `folder`: from it on, with '/'; empty: itself. Names that begin with a dot, links, devices are left out.
  tl::expected<FolderList, std::string> list(const std::string& folder) const;
  /// The place of a regular file beneath it in the file system, for whoever reads programs and what they call.
  ///   returns  an error sentence: it is none, leads out of the folder, or begins with a dot
  tl::expected<std::string, std::string> path_of(const std::string& file) const;
  /// Only programs, set-ups, tools and what goes with them, here as in path_of() and read(): never a key, whatever it is called.
  /// Of a path in the file system, as path_of() gives them and as programs make of them: beneath it, or EACCES.
  int open_for_reading(const std::string& path) const override;
  bool reaches(const std::string& path) const override { return beneath(path).has_value(); }
  tl::expected<FileText, std::string> read(const std::string& file, std::size_t most) const;
  /// Of a file as it stands; of long ones by size and time alone.
  tl::expected<FileDigest, std::string> digest(const std::string& file) const;

  struct Refused {
    std::string text;
    bool changed = false;  // since it was read
  };
  /// Written beside it and put in its place, once all is on the disk.
  ///   replaces  what stands there has this digest; nothing: there is none
  ///   returns   the new digest
  tl::expected<FileDigest, Refused> save(const std::string& file, std::string_view text, const std::optional<FileDigest>& replaces) const;

 private:
  ServedFolder(int fd, std::string path, std::string name) : fd_(fd), path_(std::move(path)), name_(std::move(name)) {}
  std::optional<std::string> beneath(const std::string& path) const;

  int fd_;
  std::string path_, name_;
};

/// By its name.
FolderEntry::Kind kind_of_file(std::string_view name);

}  // namespace kadr
