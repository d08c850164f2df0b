// Renumbering: new block numbers and the words that name them. Used by edit/program_editor; tested by tests/edit.py.

#include "edit/renumbering.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "config/control/control_def.h"
#include "texts/edit.h"

namespace kadr {
namespace {

constexpr std::int32_t first_figure_cycle = 700, last_figure_cycle = 739;  // G70 to G73, in tenths

/// Returns the letters of the words that name blocks of the program, for a code.
std::string_view letters_of(const CodeRow& row) {
  switch (row.function) {
    case Function::return_program:
    case Function::call_local:
    case Function::jump_by_input: return "P";
    case Function::turning_cycle: return row.tenth >= first_figure_cycle && row.tenth <= last_figure_cycle ? "PQ" : "";
    default: return "";
  }
}

/// Returns the offset at which the number of a block is written: after the slash of a block that can be skipped, the number of its switch,
/// and the blanks around them.
std::uint32_t place_of_number(const Block& block) {
  std::size_t at = block.where.begin;
  const auto pass_over = [&](const char* what) { at = std::min(block.text.find_first_not_of(what, at), block.text.size()); };
  pass_over(" \t");
  if (at < block.text.size() && block.text[at] == '/') {
    ++at;
    pass_over("0123456789");
  }
  pass_over(" \t");
  return static_cast<std::uint32_t>(at);
}

}  // namespace

void Renumbering::note_program(const Block& block) {
  if (block.marker == Marker::label || block.marker == Marker::program_start) ++program_;
  in_section_ = block.marker == Marker::section || (in_section_ && block.marker != Marker::program_start);
}

/// Numbers in the section of the subprograms name the subprograms (spec/s2c42 6), so they stay.
bool Renumbering::gets_number(const Block& block) const {
  if (in_section_ || block.marker != Marker::none) return false;
  if (block.has_number) return true;
  const StatementKind kind = block.statement.kind;
  const bool does_something = block.word_count > 0 || !block.assignments.empty() || kind != StatementKind::none;
  return does_something && kind != StatementKind::o_word && kind != StatementKind::system && def_->grammar.word('N').known && !block.broken;
}

tl::expected<std::vector<Renumbering::Reference>, EditFault> Renumbering::references(const Block& block) const {
  std::vector<Reference> found;
  const auto fault = [&](Span where) {
    return tl::unexpected(EditFault{block.position.line, translated(texts::edit::computed_number, block.text_of(where))});
  };
  const auto add = [&](double number, Span where, bool elsewhere) {
    if (number < 0 || number != std::floor(number) || number > 1e9) return;
    std::string_view text = block.text_of(where);
    const std::size_t begin = text.find_first_of("0123456789");
    if (begin == std::string_view::npos) return;
    text = text.substr(begin);
    found.push_back({static_cast<std::uint32_t>(number), text, {where.begin + static_cast<std::uint32_t>(begin), where.end}, elsewhere});
  };
  if (const Expression target = block.statement.value; block.statement.kind == StatementKind::go_to && target) {
    const Instruction& first = block.code[target.begin];
    if (target.end - target.begin != 1 || first.op != Op::number) return fault(block.statement.where);
    add(first.number, first.where, false);
  }
  std::string letters;
  bool elsewhere = false;
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    if (block.words[i].code < 0) continue;
    const std::int32_t row = def_->row_of(block.words[i].address, block.words[i].code);
    if (row < 0) continue;
    const CodeRow& code = def_->codes[static_cast<std::size_t>(row)];
    letters += letters_of(code);
    elsewhere = elsewhere || code.function == Function::return_program;
  }
  if (letters.empty()) return found;
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& word = block.words[i];
    if (letters.find(word.address) == std::string::npos) continue;
    if (word.expression) return fault(word.where);
    add(word.value, word.where, elsewhere);
  }
  return found;
}

tl::expected<Renumbering, EditFault> Renumbering::of(const std::shared_ptr<ByteSource>& source, std::optional<Encoding> encoding,
                                                     const ControlDef& def, const Numbering& numbering, const StopToken& stop) {
  Renumbering made(def, numbering);
  Block block;
  const auto each_block = [&](const auto& take) -> tl::expected<void, EditFault> {
    BlockReader reader(source, def.grammar, encoding);
    made.begin();
    while (!stop.requested()) {
      const auto got = reader.next(block);
      if (got && *got == BlockReader::Got::end) break;
      made.note_program(block);
      if (got)
        if (auto status = take(); !status) return status;
    }
    return {};
  };
  auto status = each_block([&]() -> tl::expected<void, EditFault> {
    const auto found = made.references(block);
    if (!found) return tl::unexpected(found.error());
    for (const Reference& one : *found) made.named_.insert(one.number);
    return {};
  });
  if (!status) return tl::unexpected(status.error());
  if (!made.named_.empty())
    status = each_block([&]() -> tl::expected<void, EditFault> {
      if (!made.gets_number(block)) return {};
      if (block.has_number && made.named_.contains(block.number)) made.new_of_[made.program_].emplace(block.number, made.next_);
      made.next_ += made.numbering_.step;
      return {};
    });
  if (!status) return tl::unexpected(status.error());
  made.begin();
  return made;
}

/// Returns the new number of the named block: that of the same program, or, for a return to a caller, of the only program that has it.
std::optional<std::uint32_t> Renumbering::new_number(const Reference& reference) const {
  std::optional<std::uint32_t> only;
  for (const auto& [program, numbers] : new_of_) {
    const auto at = numbers.find(reference.number);
    if (at == numbers.end()) continue;
    if (program == program_ && !reference.may_be_elsewhere) return at->second;
    if (!reference.may_be_elsewhere) continue;
    if (only) return std::nullopt;
    only = at->second;
  }
  return only;
}

/// Returns the number with its N, with as many digits as the block had or the control requires.
std::string Renumbering::number_word(const Block& block, std::uint32_t number) const {
  const WordFormat& format = def_->grammar.word('N');
  const bool keeps_zeros = block.has_number && block.text_of(block.number_where).find_first_of("0123456789") != std::string_view::npos &&
                           block.text_of(block.number_where)[block.text_of(block.number_where).find_first_of("0123456789")] == '0';
  const std::size_t digits = !format.drop_zeros ? format.whole_digits : keeps_zeros ? block.number_digits : 1;
  return fmt::format("{}{:0{}}", block.main_block ? ':' : 'N', number, digits);
}

tl::expected<void, EditFault> Renumbering::change(const Block& block, LineChanges& to) {
  note_program(block);
  const auto named = references(block);
  if (!named) return tl::unexpected(named.error());
  for (const Reference& one : *named) {
    const auto number = new_number(one);
    // A number that no block has stays: the program may never reach this word, and the control reports it if it does
    if (number) to.replace(one.where, fmt::format("{:0{}}", *number, one.written.starts_with('0') ? one.written.size() : 1));
  }
  if (!gets_number(block)) return {};
  const std::uint32_t number = next_;
  next_ += numbering_.step;
  const WordFormat& format = def_->grammar.word('N');
  if (format.whole_digits > 0 && std::to_string(number).size() > format.whole_digits)
    return tl::unexpected(EditFault{block.position.line, translated(texts::edit::number_too_large, number, int(format.whole_digits))});
  if (block.has_number) {
    to.replace(block.number_where, number_word(block, number));
    return {};
  }
  const std::uint32_t at = place_of_number(block);
  to.replace({at, at}, number_word(block, number) + " ");
  return {};
}

}  // namespace kadr
