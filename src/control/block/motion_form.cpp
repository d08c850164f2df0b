// Computes and keeps the forms of plain motion blocks. Used by control/block/motion_run.

#include "control/block/motion_form.h"

#include <algorithm>

#include "control/block_context.h"

namespace kadr {
namespace {

/// Returns true if the block only calls a subprogram or returns from one.
bool only_calls(const BlockContext& m, const Block& block) {
  bool calls = false, takes_words = false;
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& w = block.words[i];
    if (w.code < 0 || w.address == 0) continue;
    const std::int32_t row = m.def.row_of(w.address, w.code);
    const Function function = row < 0 ? Function::count : m.def.codes[static_cast<std::size_t>(row)].function;
    if (row < 0 || !traits_of(function).is(function_fact::passes_control)) return false;
    calls = true;
    takes_words = takes_words || function == Function::macro_call;
  }
  return calls && (takes_words || (block.letters & (m.letters.acting | m.letters.axes)) == 0);
}

/// Returns the index of the word that calls a macro, or of a return that is the block's only word; no_word for all other blocks. A block
/// with such an index either fails before it has changed anything, or succeeds.
std::uint8_t quick_call(const BlockContext& m, const Block& block) {
  std::uint8_t word = no_word;
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    if (block.words[i].code < 0) continue;
    if (word != no_word) return no_word;
    word = static_cast<std::uint8_t>(i);
  }
  const Word& w = block.words[word];
  const Function function = m.def.codes[static_cast<std::size_t>(m.def.row_of(w.address, w.code))].function;
  const bool quick = function == Function::macro_call || (function == Function::return_program && block.word_count == 1);
  return quick ? word : no_word;
}

}  // namespace

const MotionForm& MotionForms::of(const BlockContext& m, const Block& block) {
  const bool shaped = static_cast<bool>(block.shape);
  const std::uint64_t key = shaped ? block.shape.first ^ block.shape.second * 3
                                   : reinterpret_cast<std::uintptr_t>(&block) / alignof(Block);  // NOLINT: a hash key
  MotionForm& form = forms_[(key * 0x9E3779B97F4A7C15u) >> 58];                                  // as in block/shapes
  static_assert(kept == 64);
  if (shaped ? form.shape == block.shape : form.repeated == &block && form.letters == block.letters) [[likely]]
    return form;
  form = {};
  if (shaped) form.shape = block.shape;
  else form.repeated = &block, form.letters = block.letters;
  form.fits = make(m, block, form);
  form.calls = !form.fits && only_calls(m, block);
  if (form.calls && block.repeated) form.call = quick_call(m, block);
  return form;
}

/// Describes the block in `form`. Returns true if the block has only these words: axis words, each axis once; at most one motion code;
/// codes that are in force already; words of an arc centre or the radius of an arc; a feed.
bool MotionForms::make(const BlockContext& m, const Block& block, MotionForm& form) {
  constexpr double max_value = 1e9;  // the greatest absolute value that Interpreter::check_ranges accepts
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const Word& w = block.words[i];
    if (w.code >= 0) {
      if (!add_code(m, w, form)) return false;
      continue;
    }
    if (w.address == 0 || w.address != w.written || w.incremental || w.bare || w.axis) return false;
    const AddressRow& row = m.def.address(w.address);
    if (row.whole) return false;
    const MotionSlot slot{
        static_cast<std::uint8_t>(i), row.axis, row.function == Function::increment_axis, row.scale, std::max(row.least, -max_value),
        std::min(row.most, max_value)};
    if ((m.letters.axes & letter_bit(w.address)) != 0) {
      if (form.axes == MotionForm::max_words || (form.named >> row.axis & 1u) != 0) return false;
      form.named |= AxisMask{1} << row.axis;
      form.slots[form.axes++] = slot;
    } else if (row.function == Function::feed_word) {
      const bool of_axis = m.def.behaviour.feed_of_axis && m.axis_of_feed(i);
      if (form.feed.word != no_word || of_axis || !m.def.feed_codes.empty()) return false;
      form.feed = slot;
    } else if (w.address == 'R' && row.function == Function::word_of_code && m.def.behaviour.reads_arc_radius()) {
      if (form.radius.word != no_word) return false;
      form.radius = slot;
    } else {
      const auto* const axis = std::find(m.letters.center_letter.begin(), m.letters.center_letter.begin() + form.center.size(), w.address);
      const auto a = static_cast<std::size_t>(axis - m.letters.center_letter.begin());
      if (row.function != Function::center || a == form.center.size() || form.center[a].word != no_word) return false;
      form.center[a] = slot;
      form.centered = true;
    }
  }
  return form.radius.word == no_word ? form.axes != 0 || form.centered : form.axes != 0 && !form.centered;
}

bool MotionForms::add_code(const BlockContext& m, const Word& word, MotionForm& form) {
  const std::int32_t row = m.def.row_of(word.address, word.code);
  if (row < 0) return false;
  const CodeRow& code = m.def.codes[static_cast<std::size_t>(row)];
  const FunctionTraits& traits = traits_of(code.function);
  if (!code.modal || code.group == 0 || !code.works) return false;
  if (traits.is(function_fact::plain_motion)) {
    if (form.row >= 0) return false;
    form.row = static_cast<std::int16_t>(row);
    return true;
  }
  if (!traits.is(function_fact::steady) || form.codes == MotionForm::most_codes) return false;
  for (std::size_t i = 0; i < form.codes; ++i)
    if (m.def.codes[static_cast<std::size_t>(form.steady[i])].group == code.group) return false;
  form.steady[form.codes++] = static_cast<std::int16_t>(row);
  return true;
}

}  // namespace kadr
