#pragma once
// Where a path of the program memory ends on the disk, for file_writer.h: folders are entered one by one from the root's own
// descriptor, no link is followed.

#include <unistd.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/file_id.h"
#include "base/result.h"

namespace kadr::files {

/// A descriptor that closes itself.
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

/// Where a path ends: its folder, entered part by part, and what is there.
struct Place {
  Descriptor folder{-1};
  std::string file;
  std::string path;  // from the root, letters as on the disk
  There what = There::no_folder;
};

Place look_up(const std::string& root, const std::string& path);

/// What opening does with the file.
struct FileMode {
  bool creates, takes_existing, appends;
};
/// Opens the file of a place for writing. What was opened is looked at again by its descriptor, before anything in it changes.
///   returns  the descriptor
///   alarms   file_outside, file_write, file_already_open (`shown`)
Result<int> open_regular(const Place& place, const FileMode& rule, std::string_view shown, const FileSet& untouched);

std::string capitals(std::string_view text);
std::vector<std::string> parts_of(std::string_view path, char separator);
/// With `/` between.
std::string joined_parts(const std::vector<std::string>& parts);

}  // namespace kadr::files
