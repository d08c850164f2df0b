// Finds and converts lines of a program (SourceText). Used by view/page/page_session; tested by tests/serve.py.

#include "view/source_text.h"

#include <algorithm>
#include <cstring>

#include "lang/text/text_spool.h"

namespace kadr {
namespace {

/// Appends a line as UTF-8. Invalid bytes become U+FFFD.
void append_line(std::string_view bytes, Encoding encoding, std::string& text) {
  while (!bytes.empty()) {
    const Status read = append_utf8(bytes, encoding, text);
    if (read) break;
    bytes.remove_prefix(std::min<std::size_t>(std::max(read.error().where.end, read.error().where.begin + 1), bytes.size()));
    text += "\xEF\xBF\xBD";
  }
}

std::string utf8_of(std::string_view bytes, Encoding encoding) {
  std::string text;
  append_line(bytes, encoding, text);
  return text;
}

/// Returns true if a part of the text consists only of ASCII characters with line feeds as line ends, so that this part needs no
/// conversion.
bool is_plain(std::string_view piece) {
  constexpr std::uint64_t high_bits = 0x8080808080808080;
  std::uint64_t any = 0;
  std::size_t i = 0;
  for (std::uint64_t eight = 0; i + sizeof eight <= piece.size(); i += sizeof eight) {
    std::memcpy(&eight, piece.data() + i, sizeof eight);
    any |= eight;
  }
  for (; i < piece.size(); ++i) any |= static_cast<unsigned char>(piece[i]);
  return (any & high_bits) == 0 && piece.ends_with('\n') && piece.find('\r') == std::string_view::npos;
}

}  // namespace

SourceText::SourceText(std::shared_ptr<ByteSource> source, std::optional<Encoding> encoding) : source_(std::move(source)) {
  if (!source_) return;
  LineReader reader(source_);
  encoding_ = encoding.value_or(detect_encoding(reader.sample()).value_or(Encoding::utf8));
  for (Line line; reader.next(line); ++lines_)
    if (lines_ % lines_per_offset == 0) places_.push_back(line.offset);
}

std::uint64_t SourceText::bytes() const { return source_ ? source_->size() : 0; }

std::vector<std::string> SourceText::from(std::uint32_t line, std::uint32_t count) const {
  std::vector<std::string> texts;
  if (!source_ || line == 0 || line > lines_) return texts;
  LineReader reader(source_);
  const std::uint32_t place = (line - 1) / lines_per_offset;
  reader.seek(places_[place], place * lines_per_offset + 1);
  for (Line read; texts.size() < count && reader.next(read);)
    if (read.number >= line) texts.push_back(utf8_of(read.bytes, encoding_));
  return texts;
}

std::string SourceText::whole() const {
  std::string all;
  LineReader reader(source_);
  for (Line line; reader.next(line);) append_line(line.bytes, encoding_, all), all += '\n';
  return all;
}

std::shared_ptr<ByteSource> utf8_text(OpenedText text) {
  if (!text.source) return text_source({});
  const std::shared_ptr<ByteSource> source = std::move(text.source);
  LineReader reader(source);
  const Encoding encoding = text.encoding.value_or(detect_encoding(reader.sample()).value_or(Encoding::utf8));
  if (!is_tape(encoding) && each_piece(*source, is_plain)) return source;
  TextSpool spool;
  std::string bytes;
  for (Line line; reader.next(line);) {
    bytes.clear();
    append_line(line.bytes, encoding, bytes);
    spool.append(bytes += '\n');
  }
  return spool.source();
}

}  // namespace kadr
