#pragma once
// SourceText: gives the lines of a program of any length by number, as UTF-8.

#include <memory>
#include <string>
#include <vector>

#include "lang/text/line_reader.h"
#include "lang/text/utf16.h"

namespace kadr {

class SourceText {
 public:
  /// Reads the whole text once.
  explicit SourceText(OpenedText text) : SourceText(std::shared_ptr<ByteSource>(std::move(text.source)), text.encoding) {}
  SourceText(std::shared_ptr<ByteSource> source, std::optional<Encoding> encoding);

  std::uint32_t lines() const { return lines_; }
  Encoding encoding() const { return encoding_; }
  std::uint64_t bytes() const;
  /// Lines from `line` on, counted from 1; fewer at the end of the text.
  std::vector<std::string> from(std::uint32_t line, std::uint32_t count) const;
  /// The whole text, with '\n' between lines.
  std::string whole() const;

 private:
  static constexpr std::uint32_t stretch = 256;  // lines between two stored offsets

  std::shared_ptr<ByteSource> source_;
  Encoding encoding_ = Encoding::utf8;
  std::uint32_t lines_ = 0;
  std::vector<std::uint64_t> places_;  // offsets of lines 1, 257, …
};

/// A program as UTF-8 with '\n' between lines: the same source if it already has this form.
///   returns  an empty text if there is none
std::shared_ptr<ByteSource> utf8_text(OpenedText text);

}  // namespace kadr
