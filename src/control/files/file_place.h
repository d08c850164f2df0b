#pragma once
// Finds the folder and file for a path of the program memory, for file_writer.h. The folders are opened one by one, starting from the
// descriptor of the root folder, and no symbolic link is followed.

#include <unistd.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/file_id.h"
#include "base/result.h"

namespace kadr::files {

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }
  int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

enum class There : std::uint8_t { nothing, file, outside, other, no_folder };

/// The result of looking up a path: the descriptor of its folder, and what the folder has under the name of the file.
struct Place {
  Descriptor folder{-1};
  std::string file;
  std::string path;  // path from the root folder, with the letter case that the names have on the disk
  There what = There::no_folder;
};

Place look_up(const std::string& root, const std::string& path);

/// The rules for opening a file: whether the file may be created, whether it may exist, and whether writing starts at its end.
struct FileMode {
  bool creates, takes_existing, appends;
};
/// Opens the file of a place for writing. Before the contents change, the opened file is checked again through its descriptor.
///   shown    name of the file in alarms
///   returns  the descriptor
///   alarms   file_outside, file_write, file_already_open
Result<int> open_regular(const Place& place, const FileMode& rule, std::string_view shown, const FileSet& untouched);

std::string capitals(std::string_view text);
std::vector<std::string> parts_of(std::string_view path, char separator);
/// Joins the parts with `/`.
std::string joined_parts(const std::vector<std::string>& parts);

}  // namespace kadr::files
