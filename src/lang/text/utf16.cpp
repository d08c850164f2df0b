// Program text in UTF-16, as editors of Windows save it. Detects the encoding, and converts the text to UTF-8. Used by cli, control; tested
// by tests/lang/utf16_test.cpp.

#include "lang/text/utf16.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace kadr {
namespace {

constexpr std::size_t utf16_piece_bytes = 32 * 1024;  // least length of a piece in bytes of UTF-16; each piece has an entry in the index
constexpr std::size_t sample_bytes = 1024;
constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

bool is_first_half(char16_t unit) { return unit >= 0xD800 && unit <= 0xDBFF; }
bool is_second_half(char16_t unit) { return unit >= 0xDC00 && unit <= 0xDFFF; }

char16_t unit_at(std::string_view bytes, std::size_t at, ByteOrder order) {
  const auto first = static_cast<unsigned char>(bytes[at]), second = static_cast<unsigned char>(bytes[at + 1]);
  return static_cast<char16_t>(order == ByteOrder::little ? first | second << 8 : first << 8 | second);
}

void append_character(char32_t code, std::string& text) {
  const auto tail = [&](int shift) { text += static_cast<char>(0x80 | (code >> shift & 0x3F)); };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xC0 | code >> 6);
    tail(0);
  } else if (code < 0x10000) {
    text += static_cast<char>(0xE0 | code >> 12);
    tail(6), tail(0);
  } else {
    text += static_cast<char>(0xF0 | code >> 18);
    tail(12), tail(6), tail(0);
  }
}

/// Returns true for a control character other than tabs and ends of lines. Program text has no such characters; binary files and the blank
/// leader of a tape have some.
bool is_control(char16_t unit) {
  const bool of_text = unit == '\t' || unit == '\n' || unit == '\r' || unit == '\f';
  return (unit < 0x20 && !of_text) || (unit >= 0x7F && unit < 0xA0) || unit >= 0xFFFE;
}

/// Detects UTF-16 without a byte order mark. The sample must have at least two characters, and at least half of the characters must be
/// ASCII.
bool is_plainly(std::string_view sample, ByteOrder order) {
  const std::size_t size = std::min(sample.size(), sample_bytes);
  std::size_t ascii = 0, units = 0;
  for (std::size_t i = 0; i + 1 < size; i += 2, ++units) {
    const char16_t unit = unit_at(sample, i, order);
    if (is_control(unit)) return false;
    ascii += unit < 0x80;
  }
  return units >= 2 && 2 * ascii >= units;
}

std::optional<ByteOrder> order_by_mark(std::string_view sample) {
  if (sample.starts_with("\xFF\xFE")) return ByteOrder::little;
  if (sample.starts_with("\xFE\xFF")) return ByteOrder::big;
  return std::nullopt;
}

/// Reads from any offset of the UTF-8 text. The piece of the file that contains the offset is converted again. The source has no mutable
/// state, so threads may share it.
class Utf16Source final : public ByteSource {
 public:
  Utf16Source(std::unique_ptr<ByteSource> source, ByteOrder order) : source_(std::move(source)), order_(order) {
    std::string text;
    for (Mark mark;; text.clear()) {
      marks_.push_back(mark);
      const std::size_t taken = piece(mark.there, text);
      if (taken == 0) break;
      mark.there += taken;
      mark.here += text.size();
    }
  }

  std::size_t read(std::uint64_t offset, char* to, std::size_t size) override {
    std::size_t got = 0;
    std::string text;
    while (got < size && offset + got < marks_.back().here) {
      const auto after =
          std::upper_bound(marks_.begin(), marks_.end(), offset + got, [](std::uint64_t at, const Mark& mark) { return at < mark.here; });
      const Mark& mark = *std::prev(after);
      text.clear();
      piece(mark.there, text);
      const std::size_t skipped = offset + got - mark.here;
      if (skipped >= text.size()) break;  // nothing more can be read, because the file has become shorter since it was opened
      got += text.copy(to + got, size - got, skipped);
    }
    return got;
  }
  std::uint64_t size() const override { return marks_.back().here; }

 private:
  struct Mark {
    std::uint64_t there = 0;  // offset of a piece in the file, which is in UTF-16
    std::uint64_t here = 0;   // offset of the same piece in the text, which is in UTF-8
  };

  /// Converts the piece that starts at the file offset `there`. Returns the number of bytes of the file that were converted.
  std::size_t piece(std::uint64_t there, std::string& text) const {
    std::string bytes(utf16_piece_bytes, '\0');
    bytes.resize(source_->read(there, bytes.data(), bytes.size()));
    return append_utf16(bytes, order_, there + bytes.size() >= source_->size(), text);
  }

  std::unique_ptr<ByteSource> source_;
  ByteOrder order_;
  std::vector<Mark> marks_;  // start of each piece; the last element has the offsets of the end of the text
};

}  // namespace

std::optional<ByteOrder> look_at_utf16(std::string_view sample) {
  if (const auto order = order_by_mark(sample)) return order;
  if (is_plainly(sample, ByteOrder::little)) return ByteOrder::little;
  if (is_plainly(sample, ByteOrder::big)) return ByteOrder::big;
  return std::nullopt;
}

bool read_encoding(std::string_view name, GivenEncoding& given) {
  std::string plain;  // name in the spelling in which encoding_named() compares names
  for (const char c : name)
    if (c != '-' && c != '_' && c != ' ') plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  given = {};
  if (plain == "utf16") given.utf16 = Utf16::any;
  else if (plain == "utf16le") given.utf16 = Utf16::little;
  else if (plain == "utf16be") given.utf16 = Utf16::big;
  else given.encoding = encoding_named(name);
  return name.empty() || given.utf16 || given.encoding;
}

ByteOrder order_of(std::string_view sample, Utf16 given) {
  if (const auto marked = order_by_mark(sample)) return *marked;
  if (given == Utf16::any) return look_at_utf16(sample).value_or(ByteOrder::little);
  return given == Utf16::little ? ByteOrder::little : ByteOrder::big;
}

std::size_t append_utf16(std::string_view bytes, ByteOrder order, bool last, std::string& text) {
  std::size_t i = 0;
  for (; i + 1 < bytes.size(); i += 2) {
    const char16_t unit = unit_at(bytes, i, order);
    const bool pair_cut = is_first_half(unit) && i + 3 >= bytes.size();
    if (pair_cut && !last) return i;
    const char16_t next = is_first_half(unit) && !pair_cut ? unit_at(bytes, i + 2, order) : u'\0';
    if (is_second_half(next)) {
      append_character(0x10000 + ((unit & 0x3FFu) << 10) + (next & 0x3FFu), text);
      i += 2;
    } else if (is_first_half(unit) || is_second_half(unit)) {
      text += replacement;
    } else {
      append_character(unit, text);
    }
  }
  if (i == bytes.size() || !last) return i;
  text += replacement;
  return bytes.size();
}

bool append_if_utf16(std::string_view bytes, const GivenEncoding& given, std::string& text) {
  if (given.encoding) return false;
  ByteOrder order = ByteOrder::little;
  if (given.utf16) order = order_of(bytes, *given.utf16);
  else if (const auto seen = look_at_utf16(bytes)) order = *seen;
  else return false;
  append_utf16(bytes, order, true, text);
  return true;
}

OpenedText as_text(std::unique_ptr<ByteSource> source, const GivenEncoding& given) {
  if (!source || given.encoding) return {std::move(source), given.encoding};
  std::string sample(sample_bytes, '\0');
  sample.resize(source->read(0, sample.data(), sample.size()));
  const auto order = given.utf16 ? order_of(sample, *given.utf16) : look_at_utf16(sample);
  if (!order) return {std::move(source), std::nullopt};
  return {std::make_unique<Utf16Source>(std::move(source), *order), Encoding::utf8};
}

OpenedText open_text(const std::string& path, const GivenEncoding& given, const FileAccess* door) {
  return as_text(open_file(path, door), given);
}

}  // namespace kadr
