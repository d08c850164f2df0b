#pragma once
// TextSpool: a text of any length that is made piece by piece and then read, more than once: in memory while it is short, else in a
// temporary file without a name.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "lang/text/line_reader.h"

namespace kadr {

namespace limits {
inline constexpr std::uint64_t piped_bytes = std::uint64_t{256} << 20;  // that a pipe may give as a program; a file may have any length
inline constexpr std::uint64_t device_bytes = std::uint64_t{16} << 20;  // that a device may: a tape reader, a terminal
}  // namespace limits

class SpoolFile;

class TextSpool {
 public:
  static constexpr std::size_t usual_in_memory = std::size_t{4} << 20;  // bytes

  explicit TextSpool(std::size_t most_in_memory = usual_in_memory) : most_in_memory_(most_in_memory) {}

  /// Where no file can be made, or the disk is full, the rest stays in memory.
  void append(std::string_view piece) {
    kept_ += piece;
    if (kept_.size() >= most_in_memory_) spill();
  }
  /// Bytes so far.
  std::uint64_t size() const { return written_ + kept_.size(); }
  /// The text: nothing is appended afterwards.
  std::shared_ptr<ByteSource> source();

 private:
  void spill();

  std::size_t most_in_memory_;
  std::string kept_;                 // behind what is in the file
  std::shared_ptr<SpoolFile> file_;  // nullptr: none yet
  std::uint64_t written_ = 0;        // bytes, in the file
};

/// A text that others read too.
std::unique_ptr<ByteSource> shared_source(std::shared_ptr<ByteSource> text);

/// All of it.
std::string whole_text(ByteSource& source);

/// A text in pieces of some hundred kilobytes, in their order, until `take` returns false. They end with whole lines, of longer lines with
/// whole characters.
///   returns  false: `take` did
bool each_piece(ByteSource& source, const std::function<bool(std::string_view)>& take);

}  // namespace kadr
