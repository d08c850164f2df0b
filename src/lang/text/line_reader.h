#pragma once
// LineReader: splits the bytes of a program into lines. It reads a program of any length through a window in memory, from any offset.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "base/file_access.h"
#include "base/result.h"
#include "lang/text/encoding.h"

namespace kadr {

struct Line {
  std::string_view bytes;    // bytes of the line without the end of line; valid until the next call
  std::uint64_t offset = 0;  // offset of the line's first byte in the file
  std::uint32_t number = 1;  // line number, counted from 1
  bool ended = true;         // false for a last line without an end of line
  bool too_long = false;     // the line is longer than limits::line_bytes; `bytes` is the start of the line, the rest is skipped
};

/// A source of bytes: a file, or text in memory.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  /// Reads up to `size` bytes at `offset` into `to`; returns 0 at the end. Called once per window, never per line.
  virtual std::size_t read(std::uint64_t offset, char* to, std::size_t size) = 0;
  virtual std::uint64_t size() const = 0;
};

/// Opens a file. Returns nullptr if it cannot be read (the reason is in errno). Input that cannot be read twice (a pipe, a device; "-" is
/// the standard input) is stored in a TextSpool, up to limits::piped_bytes or limits::device_bytes; errno is EMSGSIZE if the input is
/// longer. `door`: if given, it opens the file, and only a regular file can be opened.
std::unique_ptr<ByteSource> open_file(const std::string& path, const FileAccess* door = nullptr);
std::unique_ptr<ByteSource> text_source(std::string text);
/// Returns a source for a text in memory that has other owners too.
std::unique_ptr<ByteSource> shared_text_source(std::shared_ptr<const std::string> text);

/// Lines end with LF or CR LF (CRs before an LF are not part of the line), or with CR alone if the sample has no LF. A UTF-8 byte order
/// mark at the start is skipped. The last end of line is not followed by an empty line.
class LineReader {
 public:
  explicit LineReader(std::shared_ptr<ByteSource> source);

  /// Reads the next line; returns false at the end.
  bool next(Line& line);
  /// Continues at the start of a line that was read before, given by its Line::offset and Line::number.
  void seek(std::uint64_t offset, std::uint32_t number);
  /// Sets the byte that ends lines: the end of a block on a tape in EIA code. To be called before the first line is read.
  void end_lines_with(char byte) { end_of_line_ = byte; }
  /// The first bytes of the file (at most 256 KiB), from which encoding and control are guessed.
  std::string_view sample();
  std::uint64_t size() const;
  /// Number of bytes read so far, for progress. Less than size() at the end if the file could not be read completely.
  std::uint64_t offset() const { return window_offset_ + position_; }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  bool fill();
  std::size_t find_end();
  bool skip_rest();

  std::shared_ptr<ByteSource> source_;  // shared with readers of other parts of the file
  std::string window_;
  std::string sample_;
  std::string long_line_;            // start of a line that is too long
  std::uint64_t window_offset_ = 0;  // offset of window_[0] in the file
  std::size_t position_ = 0;         // next byte in the window
  std::size_t filled_ = 0;
  std::size_t next_read_;  // number of bytes to read next: few after a jump, then more
  std::uint32_t line_ = 1;
  bool at_end_ = false;
  char end_of_line_ = '\n';  // CR if lines end with CR alone
};

}  // namespace kadr
