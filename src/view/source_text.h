#pragma once
// SourceText: the lines of a program of any length, by their numbers, as UTF-8.

#include <memory>
#include <string>
#include <vector>

#include "lang/text/line_reader.h"
#include "lang/text/utf16.h"

namespace kadr {

class SourceText {
 public:
  /// Goes through all of it once.
  explicit SourceText(OpenedText text) : SourceText(std::shared_ptr<ByteSource>(std::move(text.source)), text.encoding) {}
  SourceText(std::shared_ptr<ByteSource> source, std::optional<Encoding> encoding);

  std::uint32_t lines() const { return lines_; }
  Encoding encoding() const { return encoding_; }
  std::uint64_t bytes() const;
  /// From a line on, from 1; fewer at the end.
  std::vector<std::string> from(std::uint32_t line, std::uint32_t count) const;
  /// All of it, lines divided by '\n'.
  std::string whole() const;

 private:
  static constexpr std::uint32_t stretch = 256;  // lines between two places that are kept

  std::shared_ptr<ByteSource> source_;
  Encoding encoding_ = Encoding::utf8;
  std::uint32_t lines_ = 0;
  std::vector<std::uint64_t> places_;  // offsets of lines 1, 257, …
};

/// A program as UTF-8, lines divided by '\n': the text itself where it is that already.
///   returns  an empty text where there is none
std::shared_ptr<ByteSource> utf8_text(OpenedText text);

}  // namespace kadr
