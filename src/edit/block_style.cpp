// BlockStyle: how a program writes its blocks. Used by edit/pattern, edit/contour_reversal and view/page/page_blocks; tested by
// tests/edit.py and tests/serve_edit.py.

#include "edit/block_style.h"

#include <fmt/format.h>

#include <algorithm>

namespace kadr {
namespace {

constexpr std::uint32_t usual_step = 10;

}  // namespace

std::string BlockStyle::ending_of(const Block& block) {
  std::uint32_t end = std::max(block.where.begin, block.has_number ? block.number_where.end : 0);
  for (std::uint32_t i = 0; i < block.word_count; ++i) end = std::max(end, block.words[i].where.end);
  if (!block.comments.empty()) return {};
  while (end > 0 && end <= block.text.size() && block.text[end - 1] == ' ') --end;
  const std::string_view rest = block.text.substr(std::min<std::size_t>(end, block.text.size()));
  return rest.find_first_not_of(" \t\r") == std::string_view::npos ? std::string() : std::string(rest);
}

void BlockStyle::take(const Block& block) {
  if (block.marker != Marker::none || block.word_count == 0) return;
  ++blocks_;
  if (ending_.empty() && block.assignments.empty() && block.statement.kind == StatementKind::none) ending_ = ending_of(block);
  if (!block.has_number) return;
  ++numbered_;
  if (!first_) {
    const std::string_view text = block.text_of(block.number_where);
    const std::size_t begin = text.find_first_of("0123456789");
    if (begin != std::string_view::npos && text[begin] == '0') digits_ = block.number_digits;
    gap_ = block.number_where.end < block.text.size() && block.text[block.number_where.end] == ' ' ? " " : "";
    first_ = block.number;
  } else if (!step_ && block.number > *first_) {
    step_ = block.number - *first_;
  }
  greatest_ = std::max(greatest_, block.number);
  if (!after_) return;
  if (block.position.line <= *after_) last_ = block.number;
  else if (!before_) before_ = block.number;
}

BlockStyle BlockStyle::of(const std::shared_ptr<ByteSource>& source, std::optional<Encoding> encoding, const ControlDef& def,
                          std::optional<std::uint32_t> after, const StopToken& stop) {
  BlockStyle style;
  style.def_ = &def;
  style.after_ = after;
  BlockReader reader(source, def.grammar, encoding);
  Block block;
  while (!stop.requested()) {
    const auto got = reader.next(block);
    if (got && *got == BlockReader::Got::end) break;
    if (got) style.take(block);
  }
  return style;
}

std::string BlockStyle::next_number() {
  const WordFormat& format = def_->grammar.word('N');
  const bool has_numbers = def_->grammar.block_number_required || 2 * numbered_ > blocks_;
  if (!has_numbers || !format.known) return {};
  const bool fits_between = before_ && last_ + 1 < *before_;
  const std::uint32_t number = fits_between ? last_ + 1 : greatest_ + step_.value_or(usual_step);
  if (fits_between) last_ = number;
  else before_.reset(), greatest_ = number;
  if (format.whole_digits > 0 && std::to_string(number).size() > format.whole_digits) return {};
  return fmt::format("N{:0{}}", number, format.drop_zeros ? digits_ : std::size_t(format.whole_digits));
}

std::string BlockStyle::block(const std::string& words) {
  const std::string number = next_number();
  return number + (number.empty() ? "" : gap_) + words + ending_;
}

}  // namespace kadr
