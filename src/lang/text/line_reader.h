#pragma once
// LineReader: splits the bytes of a program into lines. A program of any length is read through a window in memory, from any offset.

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
  std::string_view bytes;    // bytes of the line without the end of line; valid until the next call of next()
  std::uint64_t offset = 0;  // offset of the line's first byte in the file
  std::uint32_t number = 1;  // line number, counted from 1
  bool ended = true;         // false for the last line of a file if it has no end of line
  bool too_long = false;     // the line is longer than limits::line_bytes; `bytes` has its start, and the rest is skipped
};

/// A source of bytes, which is a file or a text in memory.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  /// Reads up to `size` bytes at `offset` into `to`, and returns their number; returns 0 at the end. Called once per window, never per
  /// line.
  virtual std::size_t read(std::uint64_t offset, char* to, std::size_t size) = 0;
  virtual std::uint64_t size() const = 0;
};

/// Opens a file. Returns nullptr if the file cannot be read; errno then has the reason. Input that cannot be read twice (a pipe, a device;
/// "-" is the standard input) is stored in a TextSpool, up to limits::piped_bytes or limits::device_bytes. If the input is longer, errno is
/// EMSGSIZE. If `door` is given, `door` opens the file, and only a regular file is accepted.
std::unique_ptr<ByteSource> open_file(const std::string& path, const FileAccess* door = nullptr);
std::unique_ptr<ByteSource> text_source(std::string text);
/// Returns a source for a text in memory that also has other owners.
std::unique_ptr<ByteSource> shared_text_source(std::shared_ptr<const std::string> text);

/// Reads lines. A line ends with LF or CR LF (CRs before an LF are not part of the line), or with CR alone if the sample has no LF. A UTF-8
/// byte order mark at the start is skipped. No empty line follows the last end of line.
class LineReader {
 public:
  explicit LineReader(std::shared_ptr<ByteSource> source);

  /// Reads the next line. Returns false at the end of the source.
  bool next(Line& line);
  /// Continues at the start of a line that was read before; `offset` and `number` are those of the line.
  void seek(std::uint64_t offset, std::uint32_t number);
  /// Sets the byte that ends lines, such as the end of a block on a tape in EIA code. To be called before the first line is read.
  void end_lines_with(char byte) { end_of_line_ = byte; }
  /// Returns the first bytes of the file (at most 256 KiB), from which the encoding and the control are guessed.
  std::string_view sample();
  std::uint64_t size() const;
  /// Returns the number of bytes read so far, for a display of progress. At the end it is less than size() if the file could not be read
  /// completely.
  std::uint64_t offset() const { return window_offset_ + position_; }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  bool fill();
  std::size_t find_end();
  bool skip_rest();

  std::shared_ptr<ByteSource> source_;  // source of the bytes, shared with readers of other parts of the file
  std::string window_;
  std::string sample_;
  std::string long_line_;            // the bytes at the start of a line that is longer than permitted
  std::uint64_t window_offset_ = 0;  // offset of window_[0] in the file
  std::size_t position_ = 0;         // offset in the window of the byte to read next
  std::size_t filled_ = 0;
  std::size_t next_read_;  // number of bytes to read next; small after a jump, larger with each further read
  std::uint32_t line_ = 1;
  bool at_end_ = false;
  char end_of_line_ = '\n';  // byte that ends lines; CR if lines end with CR alone
};

}  // namespace kadr
