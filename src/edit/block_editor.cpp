// BlockEditor: changes the words of one block. Used by edit/program_editor; tested by tests/edit.py.

#include "edit/block_editor.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/units.h"
#include "config/control/tool_numbers.h"
#include "edit/number_text.h"
#include "out/program/codes.h"
#include "texts/edit.h"

namespace kadr {
namespace {

constexpr std::uint64_t bit_of(char letter) { return letter >= 'A' && letter <= 'Z' ? std::uint64_t{1} << (letter - 'A') : 0; }

constexpr std::uint32_t pair_digits = 100;  // T0303: tool 3 with offset 3

bool is_axis(const AddressRow& row) { return row.function == Function::axis || row.function == Function::machine_axis; }

constexpr bool is_offset(char letter) { return letter == 'H' || letter == 'D'; }

/// True for functions whose axis words are positions in work coordinates, although the functions are no motions: the intermediate point of
/// a return to the reference point, the centre of a rotation or scaling.
bool names_place(Function function) {
  constexpr Function all[] = {Function::reference_return, Function::approach_reference, Function::plane_rotation_on, Function::scaling_on,
                              Function::mirror_on};
  return std::find(std::begin(all), std::end(all), function) != std::end(all);
}

}  // namespace
BlockEditor::BlockEditor(const ControlDef& def, const Edits& edits, const LineUses* use)
    : def_(def), edits_(edits), use_(use), tool_(use != nullptr ? use->first_tool() : 0) {
  if (edits.plane) plane_.emplace(def, *edits.plane);
}

void BlockEditor::note_mode(const CodeRow& row) {
  switch (row.function) {
    case Function::absolute: incremental_ = false; break;
    case Function::incremental: incremental_ = true; break;
    case Function::inch: inch_ = true; break;
    case Function::millimetre: inch_ = false; break;
    case Function::centers_absolute: centres_absolute_ = true; break;
    case Function::centers_incremental: centres_absolute_ = false; break;
    default: break;
  }
}

BlockEditor::Codes BlockEditor::look(const Block& block) {
  Codes codes;
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& word = block.words[i];
    if (word.code < 0) continue;
    const std::int32_t at = def_.row_of(word.address, word.code);
    if (at < 0) continue;
    const CodeRow& row = def_.codes[static_cast<std::size_t>(at)];
    note_mode(row);
    const FunctionTraits& traits = traits_of(row.function);
    const bool moves = traits.phase == Phase::motion || traits.phase == Phase::positioning;
    if (!moves) codes.taken |= row.takes;
    codes.takes_offset = codes.takes_offset || traits.phase == Phase::length || traits.phase == Phase::compensation;
    codes.is_macro_call = codes.is_macro_call || row.function == Function::macro_call || row.function == Function::macro_modal;
    codes.keeps_places = codes.keeps_places || (traits.takes_axes() && !moves && !names_place(row.function));
  }
  return codes;
}

tl::expected<double, EditFault> BlockEditor::factor_of(const Block& block, const std::vector<Factor>& factors) const {
  if (use_ == nullptr || factors.empty()) return 1.0;
  const LineUse& use = use_->line(block.position.line);
  if (use.tools.empty()) return factor_for(factors, tool_);
  const double first = factor_for(factors, use.tools.front());
  for (const std::uint32_t tool : use.tools)
    if (factor_for(factors, tool) != first)
      return tl::unexpected(EditFault{block.position.line, translated(texts::edit::several_tools, use.tools.front(), tool)});
  return first;
}

void BlockEditor::count_unproven(const Block& block) {
  if (use_ != nullptr && !use_->line(block.position.line).executed) ++not_executed_;
}

tl::expected<void, EditFault> BlockEditor::set(const Block& block, const Word& word, double value, LineChanges& to) {
  const std::string_view text = block.text_of(word.where);
  auto made = word_with_value(text, word, def_, value);
  if (!made) return tl::unexpected(EditFault{block.position.line, translated(texts::edit::does_not_fit, text, value)});
  if (*made == text) return {};
  to.replace(word.where, std::move(*made));
  count_unproven(block);
  return {};
}

tl::expected<void, EditFault> BlockEditor::scale(const Block& block, const Word& word, double factor, LineChanges& to) {
  if (factor == 1) return {};
  if (!word.expression) return set(block, word, word.value * factor, to);
  const Span where = without_blanks(block, word.where);
  const std::string_view text = block.text_of(where);
  if (!def_.grammar.expressions && !def_.grammar.custom_macros)
    return tl::unexpected(EditFault{block.position.line, translated(texts::edit::parameter_word, text)});
  to.replace(where, word_with_operation(text, fmt::format("*{:g}", factor)));
  count_unproven(block);
  return {};
}

/// Scales a feed. The lead of a thread stays, and so does the feed of a tap, which belongs to the spindle speed.
tl::expected<void, EditFault> BlockEditor::feed_word(const Block& block, const Word& word, LineChanges& to) {
  const LineUse& use = use_->line(block.position.line);
  if (use.threads) return {};
  const auto factor = factor_of(block, use.taps ? edits_.speeds : edits_.feeds);
  return factor ? scale(block, word, *factor, to) : tl::expected<void, EditFault>(tl::unexpected(factor.error()));
}

tl::expected<void, EditFault> BlockEditor::speed_word(const Block& block, const Word& word, LineChanges& to) {
  const auto factor = factor_of(block, edits_.speeds);
  return factor ? scale(block, word, *factor, to) : tl::expected<void, EditFault>(tl::unexpected(factor.error()));
}

std::optional<std::uint32_t> BlockEditor::new_tool(std::uint32_t tool) const {
  for (const auto& [from, to] : edits_.tools)
    if (from == tool) return to;
  return std::nullopt;
}

/// Changes a tool number, and the number of an offset that equals it: T03, H03, D03, T0303.
void BlockEditor::tool_word(const Block& block, const Word& word, LineChanges& to) {
  if (word.expression || word.value < 0) return;
  const ToolNumbers old = word.address == 'T' ? tool_numbers(def_, word.value) : ToolNumbers{static_cast<std::uint32_t>(word.value)};
  const auto made = new_tool(old.tool);
  if (!made) return;
  const std::uint32_t offset = old.offset == old.tool ? *made : old.offset;
  (void)set(block, word, old.is_pair ? *made * pair_digits + offset : *made, to);
}

void BlockEditor::system_word(const Block& block, const Word& word, LineChanges& to) {
  for (const auto& [from, into] : edits_.work_systems) {
    if (word.code != from.code) continue;
    const Word* const p = block.find('P');
    if (from.further && (p == nullptr || p->expression || p->value != *from.further)) continue;
    const std::int32_t row = def_.row_of('G', into.code);
    std::string text = row < 0 ? fmt::format("G{:g}", into.code / 10.0) : with_digits(def_, def_.codes[static_cast<std::size_t>(row)]);
    if (into.further && !from.further) text += fmt::format(" P{}", *into.further);
    to.replace(word.where, std::move(text));
    if (from.further && into.further) to.replace(p->where, fmt::format("P{}", *into.further));
    else if (from.further) to.remove(p->where);
    count_unproven(block);
    return;
  }
}

bool BlockEditor::is_absolute_centre() const {
  return def_.behaviour.arc_centers == ArcCenters::by_code ? centres_absolute_
                                                           : def_.behaviour.arc_centers == ArcCenters::as_distance && !incremental_;
}

/// Shifts a position: an axis word in absolute coordinates, the centre of an arc if it is absolute, the level R of a drilling cycle.
tl::expected<void, EditFault> BlockEditor::place_word(const Block& block, const Word& word, const Codes& codes, LineChanges& to) {
  if (codes.keeps_places || word.incremental || word.axis) return {};
  const AddressRow& row = def_.address(word.address);
  std::string axis;
  if (is_axis(row) && !incremental_) axis = word.address;
  else if (row.function == Function::center && is_absolute_centre() && row.axis < def_.axes.size()) axis = def_.axes[row.axis];
  else if (word.address == 'R' && !incremental_ && def_.behaviour.lathe == Lathe::none && use_->line(block.position.line).drills)
    axis = "Z";
  const auto shift = edits_.shift.find(axis);
  if (shift == edits_.shift.end()) return {};
  const double step = shift->second / (inch_ ? mm_per_inch : 1) / row.scale;
  if (!word.expression) return set(block, word, word.value + step, to);
  const Span where = without_blanks(block, word.where);
  to.replace(where, word_with_operation(block.text_of(where), fmt::format("{:+g}", step)));
  count_unproven(block);
  return {};
}

/// Puts one space between the words of a block, or none.
void BlockEditor::spacing(const Block& block, LineChanges& to) const {
  if (block.broken || block.statement.kind != StatementKind::none || !block.assignments.empty() || block.marker != Marker::none) return;
  std::vector<Span> tokens;
  if (block.has_number) tokens.push_back(block.number_where);
  for (std::uint32_t i = 0; i < block.word_count; ++i) tokens.push_back(without_blanks(block, block.words[i].where));
  std::sort(tokens.begin(), tokens.end(), [](Span a, Span b) { return a.begin < b.begin; });
  for (std::size_t i = 1; i < tokens.size(); ++i) {
    const Span gap{tokens[i - 1].end, tokens[i].begin};
    if (gap.end < gap.begin || block.text_of(gap).find_first_not_of(" \t") != std::string_view::npos) continue;
    if (const std::string_view wanted = edits_.spaces ? " " : ""; block.text_of(gap) != wanted) to.replace(gap, std::string(wanted));
  }
}

tl::expected<void, EditFault> BlockEditor::change(const Block& block, LineChanges& to) {
  const Codes codes = look(block);
  if (use_ != nullptr)
    if (const LineUse& use = use_->line(block.position.line); !use.tools.empty()) tool_ = use.tools.back();
  for (std::uint32_t i = 0; i < block.word_count && !codes.is_macro_call; ++i) {
    const Word& word = block.words[i];
    if (word.code >= 0) {
      if (word.address == 'G') system_word(block, word, to);
      continue;
    }
    if (word.address < 'A' || word.address > 'Z' || word.bare) continue;
    const bool is_taken = (codes.taken & bit_of(word.address)) != 0;
    const bool feeds = !edits_.feeds.empty() || !edits_.speeds.empty();
    tl::expected<void, EditFault> status;
    if (word.address == 'F' && feeds && !is_taken) status = feed_word(block, word, to);
    else if (word.address == 'S' && !edits_.speeds.empty() && !is_taken) status = speed_word(block, word, to);
    else if (word.address == 'T' || (is_offset(word.address) && (codes.takes_offset || !is_taken))) tool_word(block, word, to);
    else if (!edits_.shift.empty()) status = place_word(block, word, codes, to);
    if (!status) return status;
  }
  if (plane_) {
    if (auto status = plane_->change(block, to); !status) return status;
    const std::size_t changed = plane_->take_changed();
    if (use_ != nullptr && !use_->line(block.position.line).executed) not_executed_ += changed;
  }
  if (edits_.no_numbers && block.has_number) {
    std::uint32_t end = block.number_where.end;
    while (end < block.text.size() && block.text[end] == ' ') ++end;
    to.remove({block.number_where.begin, end});
  }
  if (edits_.spaces || edits_.no_spaces) spacing(block, to);
  return {};
}

}  // namespace kadr
