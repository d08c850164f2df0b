// The steps of the Fanuc family before and after the planning of a block: data lines, macro calls, checks of the words (spec/nct/23 23.3,
// 24.1, 12.4; spec/fanuc 1.2, 1.3, 2.1). Used by control/fanuc/dialect/dialect.

#include "control/fanuc/dialect/blocks.h"

#include <bit>
#include <cmath>

#include "base/code_literals.h"
#include "control/fanuc/drilling/drilling.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/five_axis/five_axis_functions.h"
#include "control/fanuc/geometry/automatic_geometry.h"
#include "control/fanuc/geometry/sides.h"
#include "control/fanuc/words/data_lines.h"
#include "control/functions/functions.h"
#include "control/macro_b/dialect/blocks.h"

namespace kadr::fanuc {
namespace {

/// Executes letters without a number, as in `G17 X`: such a letter only selects the axis of the plane and moves nothing (10.4).
Status take_bare_words(BlockContext& m) {
  Fanuc& fanuc = fanuc_of(m);
  fanuc.plane_axes = 0;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    Word& w = m.block->words[i];
    if (w.address == 0 || (m.letters.axes & letter_bit(w.address)) == 0) continue;
    fanuc.plane_axes |= 1u << static_cast<unsigned>(m.letters.axis_of[static_cast<std::size_t>(w.address - 'A')]);
    if (!w.bare) continue;
    if (!m.has_code({Function::select_plane})) return fail(alarm(AlarmId::number_missing, w.where, w.written));
    w.address = 0;
    m.block->altered = true;
  }
  if (m.block->altered) m.note_addresses();
  return {};
}

/// Returns true if two words position the same axis of a lathe, such as X and U. The later one counts (spec/fanuc-t 3.2).
bool one_axis(const BlockContext& m, const Word& a, const Word& b) {
  if (m.def.behaviour.lathe == Lathe::none || a.address == 0) return false;
  const bool axes = (m.letters.axes & letter_bit(a.address)) != 0 && (m.letters.axes & letter_bit(b.address)) != 0;
  // In G71 to G73 the words U and W are depths and allowances, and in G4 X and U are times
  if (!axes || m.has_code({Function::turning_cycle, Function::dwell_or_turns})) return false;
  return m.def.address(a.address).axis == m.def.address(b.address).axis;
}

/// Drops repeated words. Of two words with one address, or two codes of one group, only the last counts (spec/fanuc 1.2, 2.1).
void drop_repeated(BlockContext& m) {
  const auto group_of = [&](const Word& w) {
    const std::int32_t row = w.code < 0 ? -1 : m.def.row_of(w.address, w.code);
    return row < 0 ? 0 : int{m.def.codes[static_cast<std::size_t>(row)].group};
  };
  for (std::uint32_t i = 1; i < m.block->word_count; ++i) {
    const Word& last = m.block->words[i];
    if (last.address == 0) continue;
    const bool is_code = (m.letters.codes & letter_bit(last.address)) != 0;
    const int group = is_code ? group_of(last) : 0;
    if (is_code && group == 0) continue;
    for (std::uint32_t k = 0; k < i; ++k) {
      Word& before = m.block->words[k];
      const bool same = before.address == last.address || one_axis(m, before, last);
      if (!same || before.bare || (is_code && group_of(before) != group)) continue;  // an address without a number stays an alarm (1.3)
      before.address = 0;
      m.block->altered = true;
    }
  }
  if (m.block->altered) m.note_addresses();
}

/// Drops a block number behind other words, as in `M01N02`, with a warning. INFERRED: the words of a block may have any order (spec/fanuc
/// 1.2), and real programs have it; GOTO and cycles do not find such a number, because N must be the first word (5.4).
void drop_late_number(Emitter& m) {
  if (!m.has('N') || !m.def.behaviour.words_passed_over) return;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    Word& w = m.block->words[i];
    if (w.address != 'N') continue;
    m.warn(warning(AlarmId::block_number_position, w.where));
    w.address = 0;
    m.block->altered = true;
  }
  if (m.block->altered) m.note_addresses();
}

/// Checks that a block with a multiple repetitive cycle of a Fanuc lathe has no other code that acts once, none of group 01, no unit, and
/// no call or return (spec/fanuc-t 9.1).
///   alarms  cycle_block_unavailable (PS0066)
Status check_cycle_block(const BlockContext& m) {
  if (m.def.behaviour.lathe != Lathe::fanuc || !m.has_code({Function::turning_cycle})) return {};
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    const std::int32_t index = w.address == 0 || w.code < 0 ? -1 : m.def.row_of(w.address, w.code);
    if (index < 0) continue;
    const CodeRow& row = m.def.codes[static_cast<std::size_t>(index)];
    const Fanuc& fanuc = fanuc_of(m);
    const bool own = row.function == Function::turning_cycle;
    const bool acts_once = w.address == 'G' && (!row.modal || row.group == fanuc.motion_group || row.group == fanuc.drilling_group);
    const bool unit = row.function == Function::inch || row.function == Function::millimetre;
    if (!own && (acts_once || unit || row.phase == Phase::flow))
      return fail(alarm(AlarmId::cycle_block_unavailable, w.where, m.block->text_of(w.where)));
  }
  return {};
}

/// Checks that compensation is off where the program ends, on a control that has an alarm for this (spec/haas-st 8). INFERRED: G40 in the
/// block of the end is enough.
///   alarms  compensation_at_end (Haas 349)
Status check_end(const BlockContext& m) {
  if (m.modal.radius_side == 0 || !m.def.gives(AlarmId::compensation_at_end)) return {};
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    const std::int32_t index = w.address != 'M' || w.code < 0 ? -1 : m.def.row_of('M', w.code);
    const bool ends = index >= 0 && m.def.codes[static_cast<std::size_t>(index)].function == Function::program_end;
    if (ends && !m.has_code({Function::radius_side})) return fail(alarm(AlarmId::compensation_at_end, w.where, m.block->text_of(w.where)));
  }
  return {};
}

/// Checks that no address occurs twice in the block, even in different spellings, and that the block has no more M codes than the control
/// allows and at most one M code of each exclusive group (nct 13.1).
Status check_words(const BlockContext& m) {
  std::uint64_t seen = 0;
  std::size_t m_codes = 0;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address == 0) continue;
    if (w.address == 'M') ++m_codes;
    if (w.address == 'N') return fail(alarm(AlarmId::block_number_position, w.where));
    if ((m.letters.codes & letter_bit(w.address)) != 0) continue;
    if ((seen & letter_bit(w.address)) != 0) return fail(alarm(AlarmId::address_twice, w.where, w.address));
    seen |= letter_bit(w.address);
  }
  if (m_codes < 2) return {};
  const std::uint32_t most = m.def.behaviour.m_codes_of_block;
  if (m_codes > most) return fail(alarm(AlarmId::too_many_m_codes, m.block->where, double(m_codes), double(most)));
  return check_m_codes(m);
}

/// Raises an alarm for a decimal point in a word that must not have one, such as S1000.0 (spec/fanuc 1.3). An argument of a macro call may
/// have a decimal point, whatever its letter.
Status check_points(const BlockContext& m) {
  const std::uint64_t concerned = fanuc_of(m).without_point;
  if ((m.block->letters & concerned) == 0) return {};
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.has_point && w.address != 0 && (letter_bit(w.address) & concerned) != 0)
      return fail(alarm(AlarmId::point_not_allowed, w.where, w.address));
  }
  return {};
}

/// Raises an alarm if two functions of the block use the word P, because the meaning of P is then unclear (8, 10.2.2, 14.4.2).
Status one_meaning_of_p(const BlockContext& m) {
  if (!m.has('P')) return {};
  const CodeRow* first = nullptr;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    const std::int32_t index = w.code < 0 || w.address == 0 ? -1 : m.def.row_of(w.address, w.code);
    if (index < 0) continue;
    const CodeRow& row = m.def.codes[static_cast<std::size_t>(index)];
    const Function f = row.function;
    const bool takes = f == Function::dwell_or_turns || f == Function::work_system_extended || f == Function::call_program ||
                       f == Function::return_program || f == Function::interrupt_on || f == Function::set_tables ||
                       f == Function::dynamic_zero || (f == Function::tool_lead && row.arg != 43.1_g) ||
                       (f == Function::reference_return && row.arg == 2);
    if (!takes) continue;
    if (first != nullptr) return fail(alarm(AlarmId::not_together, w.where, first->code, row.code));
    first = &row;
  }
  return {};
}

/// Reads the spindle words: at most one spindle per block. In `S1500 P2`, P is the spindle's number, and the block has no other words
/// (11.1.1).
Status take_spindle_words(BlockContext& m) {
  fanuc_of(m).spindle_by_p = 0;
  if ((m.block->letters & m.letters.spindles) == 0) return {};
  const Word* first = nullptr;
  bool codes = false;
  Word* p = nullptr;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    Word& w = m.block->words[i];
    if (w.address == 0) continue;
    codes = codes || w.address == 'G' || w.address == 'M';
    if (w.address == 'P') p = &w;
    if (m.def.address(w.address).function != Function::spindle_word) continue;
    if (first != nullptr) return fail(alarm(AlarmId::one_spindle, w.where, m.block->text_of(first->where), m.block->text_of(w.where)));
    first = &w;
  }
  if (first == nullptr || p == nullptr || codes) return {};
  // 11.1.1: a block with a spindle number P has only the words S and P
  if (m.block->word_count > 2) return fail(alarm(AlarmId::own_block, p->where, m.block->text_of(first->where)));
  const auto number = m.whole('P', 1, max_spindles);
  if (!number) return fail(number.error());
  fanuc_of(m).spindle_by_p = static_cast<int>(*number);
  p->address = 0;
  m.block->altered = true;
  m.note_addresses();
  return {};
}

}  // namespace

/// Scales numbers without a decimal point, which count least increments of the unit in force: 0.001 mm or 0.0001 in. A feed per minute is a
/// whole number (spec/fanuc 1.3), unless a parameter changes this. A block that is executed again may need another increment, so its words
/// are scaled at each execution; a word that has been scaled already (Word::counted) does not change.
void count_increments(BlockContext& m) {
  if (m.def.grammar.least_increments.empty()) return;
  const bool inch = m.has_code({Function::inch}) || (m.modal.inch && !m.has_code({Function::millimetre}));
  if (!inch && !m.block->evaluates && !m.has('F')) return;  // nothing to scale: the reader has already counted the numbers in 0.001 mm
  const Settings& s = fanuc_of(m).settings;
  const bool turns = m.has_code({Function::feed_per_revolution}) ||
                     (m.modal.feed_mode == FeedMode::per_revolution && !m.has_code({Function::feed_per_minute}));
  const bool calls_macro = m.block->evaluates && m.has_code({Function::macro_call, Function::macro_modal});
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    Word& w = m.block->words[i];
    const WordFormat& format = m.def.grammar.word(w.written);
    if (w.expression && format.counted != 0 && !calls_macro) {
      const double parts = inch && (w.written < 'A' || w.written > 'C') ? 10'000 : 1000;
      w.value = std::round(w.value * parts) / parts;
    }
    if (w.has_point || w.bare || w.code >= 0 || w.expression) continue;
    if (format.counted == 0 && w.written != 'F') continue;
    const bool length = w.written == 'F' || (w.written < 'A' || w.written > 'C');
    const bool as_length = w.written != 'F' || s.feed_counts_increments;
    const int least = as_length || (s.feed_in_thousandths && !turns) ? 3 : (s.feed_whole || !turns) ? 0 : 2;
    const int finer = !inch || !length ? 0 : as_length ? 1 : s.feed_whole ? 0 : 2;
    const int decimals = least + finer;
    if (decimals == w.counted) continue;
    w.value *= std::pow(10.0, int{w.counted} - decimals);
    w.counted = static_cast<std::uint8_t>(decimals);
  }
}

Result<bool> before_plan(Interpreter& m) {
  Fanuc& fanuc = fanuc_of(m);
  fanuc.holds_vector = false;
  fanuc.taken_up = fanuc.by_direction = 0;
  fanuc.uncompensated = fanuc.state.compensates && m.has_code({Function::machine_move, Function::reference_return});
  begin_words(m);
  if (macro_b_of(m).state.data_mode != DataMode::none) {
    fanuc.keep_all();
    KADR_TRY(check_values(m));
    KADR_TRY(data_line(m));
    return true;
  }
  if (const auto called = call_with_words(m); !called || *called) return called;
  const bool looks_closer = watches_words(m) || watches_codes(m);
  if (m.block->repeated && m.block->checked == m.block->letters && !m.block->codes_vary &&
      !looks_closer) {  // if an earlier execution of this block has checked the words, only increments and values are processed again
    if (!m.block->calls_macro) count_increments(m);
    // values of expressions may have changed since the block was executed before, so their ranges are checked again
    if (m.block->evaluates && !m.block->calls_macro) KADR_TRY(check_values(m));
    if (!m.block->calls_macro) note_words(m);
    else if (m.block->has_number) macro_b_of(m).state.words.n = m.block->number;
    return false;
  }
  if (const ShapeFacts* const shape = m.shape(); shape != nullptr && shape->words_right && !looks_closer) {
    KADR_TRY(check_end(m));
    KADR_TRY(check_points(m));
    count_increments(m);
    KADR_TRY(check_values(m));
    note_words(m);
    m.block->calls_macro = false;
    m.block->checked = m.block->letters;
    return false;
  }
  m.block->calls_macro = m.has('G') && m.has_code({Function::macro_call, Function::macro_modal});
  if (m.block->calls_macro) {
    KADR_TRY(one_g(m));
    if (m.block->has_number) macro_b_of(m).state.words.n = m.block->number;
    m.block->checked = m.block->letters;
    return false;
  }
  drop_late_number(m);
  KADR_TRY(check_cycle_block(m));
  KADR_TRY(check_end(m));
  KADR_TRY(check_points(m));
  if (m.def.behaviour.later_word_counts == LaterWord::everywhere) drop_repeated(m);
  count_increments(m);
  KADR_TRY(check_values(m));
  KADR_TRY(take_bare_words(m));
  take_corner_letters(m);
  KADR_TRY(five_axis_block(m));
  KADR_TRY(check_words(m));
  KADR_TRY(take_spindle_words(m));
  KADR_TRY(one_meaning_of_p(m));
  KADR_TRY(check_increment_of_r(m));
  const bool plain =
      !m.block->altered && !looks_closer && (m.block->letters & m.letters.spindles) == 0 && !m.has_code({Function::select_plane});
  m.block->checked = plain ? m.block->letters : 0;
  if (ShapeFacts* const shape = m.shape(); shape != nullptr) shape->words_right = plain;
  note_words(m);
  return false;
}

Status after_block(Interpreter& m) {
  if (fanuc_of(m).state.side_step != SideStep::none) end_side_block(m);
  KADR_TRY(check_drilling(m));
  return end_words(m);
}

}  // namespace kadr::fanuc
