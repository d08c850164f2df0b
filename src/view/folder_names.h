#pragma once
// Names of files beneath the served folder: which may be read, which may be created, and how the kernel opens them without leaving the
// folder.

#include <fcntl.h>
#include <sys/stat.h>

#include <mutex>
#include <string>
#include <string_view>
#include <utility>

namespace kadr::served {

/// A file descriptor that is closed at the end of its scope.
class OpenFile {
 public:
  explicit OpenFile(int fd) : fd_(fd) {}
  OpenFile(OpenFile&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  OpenFile& operator=(OpenFile&&) = delete;
  ~OpenFile();
  int fd() const { return fd_; }
  bool is_open() const { return fd_ >= 0; }
  void replace(OpenFile&& by) { std::swap(fd_, by.fd_); }
  int release() { return std::exchange(fd_, -1); }

 private:
  int fd_;
};

/// Opens a file beneath a folder. Links are not followed, so the file is certainly beneath the folder.
OpenFile open(int folder, const std::string& name, int flags, mode_t mode = 0);
/// Does the same where the kernel cannot: opens one folder after another, and never a link. `..` is refused.
OpenFile open_by_parts(int folder, const std::string& name, int flags, mode_t mode = 0);

/// Returns true if a component of the name is hidden (begins with a dot) or empty.
bool is_hidden(std::string_view name);

/// Returns true if the name has no control characters. Other names are refused, because controls and users write file names into programs.
bool is_plain_name(std::string_view name);

/// Returns the ending of a file name in lower case.
std::string ending_of(std::string_view name);

/// Returns true for the endings of files that belong to programs: drawings, bodies, tables of LinuxCNC.
bool is_with_programs(std::string_view name);

/// Returns the sentence that refuses a file that is not served.
std::string refusal(const std::string& file);
std::string of_errno(const std::string& file, int error);

/// Returns the folder of a path, without the last slash; empty: the served folder itself.
std::string folder_part(const std::string& file);
/// Returns the last component of a path.
std::string last_part(const std::string& file);

/// Decides whether a file of this name may be created in a folder. The name must be that of a program, a set-up or a file that belongs to
/// programs, it must exist on Windows too, and it must not differ from another name of the folder by its case alone.
///   folder   where the file will be
///   last     the last component of the name
///   besides  a name of the folder that does not count, because the file gives it up; empty: none
///   returns  an error sentence; empty if the name is good
std::string fault_of_new_name(const OpenFile& folder, const std::string& last, const std::string& besides = "");

/// Renames a file, unless a file of the new name exists.
///   returns  an errno; 0 on success
int rename_to_new(const OpenFile& from_folder, const std::string& from, const OpenFile& to_folder, const std::string& to);

/// Writes a new file: the text under another name first, and this file is renamed when all data are on the disk.
///   returns  an errno; EEXIST if a file of this name exists; 0 on success
int write_new(const OpenFile& folder, const std::string& last, std::string_view text);

/// Lets only one thread of the server change files at a time, so that a file that was checked does not change before it is replaced.
std::mutex& changes_lock();

}  // namespace kadr::served
