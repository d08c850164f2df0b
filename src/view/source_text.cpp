// Lines by number. For view/page_session; tested by tests/view/source_text_test.cpp.

#include "view/source_text.h"

#include <algorithm>

namespace kadr {

SourceText::SourceText(std::shared_ptr<ByteSource> source, std::optional<Encoding> encoding) : source_(std::move(source)) {
  if (!source_) return;
  LineReader reader(source_);
  encoding_ = encoding.value_or(detect_encoding(reader.sample()).value_or(Encoding::utf8));
  for (Line line; reader.next(line); ++lines_)
    if (lines_ % stretch == 0) places_.push_back(line.offset);
}

std::uint64_t SourceText::bytes() const { return source_ ? source_->size() : 0; }

/// What is damaged is shown as U+FFFD, so that what the page gets is UTF-8.
std::string SourceText::utf8(std::string_view bytes) const {
  std::string text;
  while (!bytes.empty()) {
    const Status read = append_utf8(bytes, encoding_, text);
    if (read) break;
    bytes.remove_prefix(std::min<std::size_t>(std::max(read.error().where.end, read.error().where.begin + 1), bytes.size()));
    text += "\xEF\xBF\xBD";
  }
  return text;
}

std::vector<std::string> SourceText::from(std::uint32_t line, std::uint32_t count) const {
  std::vector<std::string> texts;
  if (!source_ || line == 0 || line > lines_) return texts;
  LineReader reader(source_);
  const std::uint32_t place = (line - 1) / stretch;
  reader.seek(places_[place], place * stretch + 1);
  for (Line read; texts.size() < count && reader.next(read);)
    if (read.number >= line) texts.push_back(utf8(read.bytes));
  return texts;
}

std::string SourceText::whole() const {
  std::string all;
  LineReader reader(source_);
  for (Line line; reader.next(line);) all += utf8(line.bytes), all += '\n';
  return all;
}

}  // namespace kadr
