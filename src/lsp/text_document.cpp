// TextDocument: the text of a program in an editor. Used by lsp/language_server; tested by tests/lsp/text_document_test.cpp.

#include "lsp/text_document.h"

#include <algorithm>

namespace kadr {
namespace {

/// Returns the length of a character in bytes, by its first byte. A byte that begins no character counts as one.
std::size_t bytes_of_character(unsigned char first) {
  if (first >= 0xF0 && first < 0xF8) return 4;
  if (first >= 0xE0) return first < 0xF0 ? 3 : 1;
  return first >= 0xC0 ? 2 : 1;
}

std::uint32_t units_of_character(std::size_t bytes, ColumnUnit unit) {
  if (unit == ColumnUnit::utf8) return static_cast<std::uint32_t>(bytes);
  return unit == ColumnUnit::utf16 && bytes == 4 ? 2 : 1;  // a character above U+FFFF is a pair of surrogates
}

}  // namespace

TextDocument::TextDocument(std::string text, ColumnUnit unit) : unit_(unit) { replace(std::move(text)); }

/// Appends the starts of the lines that begin after `from`, up to and including `to`.
void TextDocument::find_starts(std::size_t from, std::size_t to, std::vector<std::size_t>& starts) const {
  for (std::size_t at = from; at < to; ++at) {
    const char c = text_[at];
    if (c == '\n' || (c == '\r' && (at + 1 == text_.size() || text_[at + 1] != '\n'))) starts.push_back(at + 1);
  }
}

TextDocument::ChangedLines TextDocument::replace(std::string text) {
  const std::size_t removed = starts_.size();
  text_ = std::move(text);
  starts_.assign(1, 0);
  find_starts(0, text_.size(), starts_);
  return {0, removed, starts_.size()};
}

std::string_view TextDocument::line(std::size_t number) const {
  if (number >= starts_.size()) return {};
  const std::size_t end = number + 1 < starts_.size() ? starts_[number + 1] : text_.size();
  std::string_view line = std::string_view(text_).substr(starts_[number], end - starts_[number]);
  while (line.ends_with('\n') || line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::size_t TextDocument::byte_of(const TextPosition& position) const {
  const std::string_view text = line(position.line);
  std::size_t byte = 0;
  for (std::uint32_t units = 0; byte < text.size();) {
    const std::size_t bytes = bytes_of_character(static_cast<unsigned char>(text[byte]));
    units += units_of_character(bytes, unit_);
    if (units > position.column) break;
    byte += bytes;
  }
  return std::min(byte, text.size());
}

std::uint32_t TextDocument::column_of(std::size_t number, std::size_t byte) const {
  const std::string_view text = line(number);
  std::uint32_t units = 0;
  for (std::size_t at = 0; at < std::min(byte, text.size());) {
    const std::size_t bytes = bytes_of_character(static_cast<unsigned char>(text[at]));
    units += units_of_character(bytes, unit_);
    at += bytes;
  }
  return units;
}

std::uint32_t TextDocument::column_of_character(std::size_t number, std::uint32_t character) const {
  const std::string_view text = line(number);
  std::size_t byte = 0;
  for (std::uint32_t n = 1; n < character && byte < text.size(); ++n) byte += bytes_of_character(static_cast<unsigned char>(text[byte]));
  return column_of(number, byte);
}

TextRange TextDocument::range_of(std::size_t number, Span bytes) const {
  const auto at = static_cast<std::uint32_t>(number);
  return {{at, column_of(number, bytes.begin)}, {at, column_of(number, bytes.end)}};
}

TextRange TextDocument::range_of_line(std::size_t number) const {
  return range_of(number, {0, static_cast<std::uint32_t>(line(number).size())});
}

std::size_t TextDocument::offset_of(const TextPosition& position) const {
  return position.line >= starts_.size() ? text_.size() : starts_[position.line] + byte_of(position);
}

TextDocument::ChangedLines TextDocument::change(const TextRange& range, std::string_view text) {
  const std::size_t begin = offset_of(range.start), end = std::max(begin, offset_of(range.end));
  const auto line_of = [&](std::size_t offset) {
    return static_cast<std::size_t>(std::upper_bound(starts_.begin(), starts_.end(), offset) - starts_.begin()) - 1;
  };
  // One line before and after the change is read again, because CR and LF at its edges may come together or apart.
  const std::size_t first = line_of(begin) == 0 ? 0 : line_of(begin) - 1, last = std::min(line_of(end) + 1, starts_.size() - 1);
  text_.replace(begin, end - begin, text);
  const std::size_t tail = last + 1 < starts_.size() ? starts_[last + 1] - end + begin + text.size() : text_.size();
  std::vector<std::size_t> starts;
  find_starts(starts_[first], tail, starts);
  if (last + 1 < starts_.size() && !starts.empty() && starts.back() == tail) starts.pop_back();  // it is the start of the line after `last`
  for (std::size_t n = last + 1; n < starts_.size(); ++n) starts_[n] = starts_[n] - end + begin + text.size();
  const auto at = starts_.begin() + static_cast<std::ptrdiff_t>(first) + 1;
  starts_.insert(starts_.erase(at, starts_.begin() + static_cast<std::ptrdiff_t>(last) + 1), starts.begin(), starts.end());
  return {first, last - first + 1, starts.size() + 1};
}

}  // namespace kadr
