#pragma once
// TextSpool: collects a text of any length piece by piece, so that the text can be read more than once. A short text is in memory, a long
// one in a temporary file without a name.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "lang/text/line_reader.h"

namespace kadr {

namespace limits {
inline constexpr std::uint64_t piped_bytes = std::uint64_t{256} << 20;  // longest program from a pipe; a file may have any length
inline constexpr std::uint64_t device_bytes = std::uint64_t{16} << 20;  // longest program from a device: a tape reader, a terminal
}  // namespace limits

class SpoolFile;

class TextSpool {
 public:
  static constexpr std::size_t usual_in_memory = std::size_t{4} << 20;  // bytes

  explicit TextSpool(std::size_t most_in_memory = usual_in_memory) : most_in_memory_(most_in_memory) {}

  /// Appends a piece. If no file can be created, or the disk is full, the rest stays in memory.
  void append(std::string_view piece) {
    kept_ += piece;
    if (kept_.size() >= most_in_memory_) spill();
  }
  /// Returns the number of bytes appended so far.
  std::uint64_t size() const { return written_ + kept_.size(); }
  /// Returns the text; nothing may be appended afterwards.
  std::shared_ptr<ByteSource> source();

 private:
  void spill();

  std::size_t most_in_memory_;
  std::string kept_;                 // the end of the text, after the part in the file
  std::shared_ptr<SpoolFile> file_;  // nullptr: no file created yet
  std::uint64_t written_ = 0;        // bytes in the file
};

/// Returns a source for a text that has other readers too.
std::unique_ptr<ByteSource> shared_source(std::shared_ptr<ByteSource> text);

/// Returns the whole text.
std::string whole_text(ByteSource& source);

/// Passes a text to `take` in order, in pieces of some hundred kilobytes, until `take` returns false. A piece ends at the end of a line;
/// pieces of a line longer than that end with a whole character.
///   returns  false if `take` has returned false
bool each_piece(ByteSource& source, const std::function<bool(std::string_view)>& take);

}  // namespace kadr
