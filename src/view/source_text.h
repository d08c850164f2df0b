#pragma once
// SourceText: returns lines of a program by their numbers, as UTF-8. Only a few line positions are stored, so the program may have any
// length.

#include <memory>
#include <string>
#include <vector>

#include "lang/text/line_reader.h"
#include "lang/text/utf16.h"

namespace kadr {

class SourceText {
 public:
  /// Reads the whole text once, to find where the lines begin.
  explicit SourceText(OpenedText text) : SourceText(std::shared_ptr<ByteSource>(std::move(text.source)), text.encoding) {}
  SourceText(std::shared_ptr<ByteSource> source, std::optional<Encoding> encoding);

  std::uint32_t lines() const { return lines_; }
  Encoding encoding() const { return encoding_; }
  std::uint64_t bytes() const;
  /// Returns `count` lines from the line `line` on, which is counted from 1. Returns fewer lines at the end of the text.
  std::vector<std::string> from(std::uint32_t line, std::uint32_t count) const;
  /// Returns the whole text, with line feeds between lines.
  std::string whole() const;

 private:
  static constexpr std::uint32_t lines_per_offset = 256;  // number of lines from one stored offset to the next

  std::shared_ptr<ByteSource> source_;
  Encoding encoding_ = Encoding::utf8;
  std::uint32_t lines_ = 0;
  std::vector<std::uint64_t> places_;  // positions in bytes of the lines 1, 257, …
};

/// Converts a program to UTF-8 with line feeds between lines. If the source already has this form, returns the source itself.
///   returns  an empty text if there is no text
std::shared_ptr<ByteSource> utf8_text(OpenedText text);

}  // namespace kadr
