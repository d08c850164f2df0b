#pragma once
// TextSpool: collects a text of any length piece by piece, so that the text can be read more than once. A short text remains in memory; a
// long one is stored in a temporary file without a name.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "lang/text/line_reader.h"

namespace kadr {

namespace limits {
// Greatest length in bytes of a program from a pipe; a program from a file may have any length.
inline constexpr std::uint64_t piped_bytes = std::uint64_t{256} << 20;
// Greatest length in bytes of a program from a device: a tape reader, a terminal.
inline constexpr std::uint64_t device_bytes = std::uint64_t{16} << 20;
}  // namespace limits

class SpoolFile;

class TextSpool {
 public:
  static constexpr std::size_t usual_in_memory = std::size_t{4} << 20;  // bytes

  explicit TextSpool(std::size_t most_in_memory = usual_in_memory) : most_in_memory_(most_in_memory) {}

  /// Appends a piece. If no file can be created, or the disk is full, the rest of the text remains in memory.
  void append(std::string_view piece) {
    in_memory_ += piece;
    if (in_memory_.size() >= most_in_memory_) spill();
  }
  /// Returns the number of bytes appended so far.
  std::uint64_t size() const { return written_ + in_memory_.size(); }
  /// Returns the text. After this call nothing may be appended.
  std::shared_ptr<ByteSource> source();

 private:
  void spill();

  std::size_t most_in_memory_;
  std::string in_memory_;            // end of the text, which follows the part in the file
  std::shared_ptr<SpoolFile> file_;  // temporary file with the first part of the text; nullptr: no file has been created yet
  std::uint64_t written_ = 0;        // bytes in the file
};

/// Returns a source for a text that also has other readers.
std::unique_ptr<ByteSource> shared_source(std::shared_ptr<ByteSource> text);

/// Returns the whole text.
std::string whole_text(ByteSource& source);

/// Passes a text to `take` in order, in pieces of some hundred kilobytes, until `take` returns false. A piece ends at the end of a line. If
/// a line is longer than a piece, its pieces end with a whole character.
///   returns  false if `take` has returned false
bool each_piece(ByteSource& source, const std::function<bool(std::string_view)>& take);

}  // namespace kadr
