#pragma once
// TextDocument: the text of a program in an editor, with the changes that the editor reports. Positions count lines and columns from 0, as
// the Language Server Protocol does; a column counts the units on which client and server have agreed.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/span.h"

namespace kadr {

/// The unit in which columns are counted (LSP 3.17, "PositionEncodingKind"): bytes of UTF-8, units of 16 bits of UTF-16, or characters.
enum class ColumnUnit : std::uint8_t { utf8, utf16, utf32 };

struct TextPosition {
  std::uint32_t line = 0, column = 0;
  friend auto operator<=>(const TextPosition&, const TextPosition&) = default;
};

struct TextRange {
  TextPosition start, end;  // `end` is the position after the last character
  friend bool operator==(const TextRange&, const TextRange&) = default;
};

class TextDocument {
 public:
  /// The lines that a change replaced: `removed` lines, from `first` on, became `added` lines.
  struct ChangedLines {
    std::size_t first = 0, removed = 0, added = 0;
  };

  TextDocument(std::string text, ColumnUnit unit);

  const std::string& text() const { return text_; }
  /// A text has one line more than it has line breaks (LF, CR LF, or CR).
  std::size_t lines() const { return starts_.size(); }
  /// Returns the line without its line break; empty if there is no such line.
  std::string_view line(std::size_t number) const;

  /// Replaces the range by the text. A range that is outside the document is moved to its edge.
  ChangedLines change(const TextRange& range, std::string_view text);
  /// Replaces the whole text.
  ChangedLines replace(std::string text);

  /// Returns the offset of a position in its line, in bytes, and back. A column after the end of the line becomes the end of the line.
  std::size_t byte_of(const TextPosition& position) const;
  std::uint32_t column_of(std::size_t line, std::size_t byte) const;
  /// Converts a span of bytes in a line.
  TextRange range_of(std::size_t line, Span bytes) const;
  TextRange range_of_line(std::size_t line) const;
  /// Returns the column of the character with this number, counted from 1, as findings state columns.
  std::uint32_t column_of_character(std::size_t line, std::uint32_t character) const;

 private:
  std::size_t offset_of(const TextPosition& position) const;
  void find_starts(std::size_t from, std::size_t to, std::vector<std::size_t>& starts) const;

  std::string text_;
  std::vector<std::size_t> starts_;  // offset of the first byte of each line
  ColumnUnit unit_;
};

}  // namespace kadr
