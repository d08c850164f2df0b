// The steps that a control with macros adds to the execution of a block by the interpreter: macro calls in place of the block, single-block
// stops, pending calls (spec/nct/23 23.3, 23.5). All controls share the interpreter. Used by control/fanuc/dialect/blocks.

#include "control/macro_b/dialect/blocks.h"

#include <cmath>

#include "control/functions/functions.h"
#include "control/macro_b/calls/calls.h"
#include "control/macro_b/macro_b.h"

namespace kadr::macro_b {
namespace {

/// Restores the words that an earlier execution of the same block removed.
void give_back(BlockContext& m) {
  if (!m.block->altered) return;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i)
    if (Word& w = m.block->words[i]; !w.expression) w.address = w.written;
  m.block->altered = false;
  m.note_addresses();
}

/// Calls the macro of G66.1 with the block's words as arguments (23.3.3). Returns false if no G66.1 is in force for the block.
Result<bool> call_with_block(Interpreter& m) {
  MacroB& macros = macro_b_of(m);
  if (macros.state.active_modal_calls == 0 || !macros.state.modal_calls[macros.state.active_modal_calls - 1u].each_block) return false;
  if (m.block->word_count == 0 || m.has_code({Function::macro_modal_off, Function::return_program, Function::macro_modal})) return false;
  Locals arguments;
  // Every word of the block is an argument of G66.1, because no word of the block makes the call.
  KADR_TRY(arguments_of(m, limits::block_words, arguments));
  KADR_TRY(call_modal(m, arguments));
  return true;
}

/// Returns true inside programs 8000–8999 and 9000–9999. In single-block operation such a program runs together with its call as one block,
/// unless a parameter makes its blocks stop (23.3.9).
bool hidden(const BlockContext& m) {
  const std::uint32_t number = number_of_file(m.program().file());
  const Settings& s = macro_b_of(m).settings;
  return (number >= 8000 && number < 9000 && !s.lists_8000) || (number >= 9000 && number < 10000 && !s.lists_9000);
}

bool may_stop(const BlockContext& m) {
  constexpr std::uint32_t m_ov = 2;  // #3004 bit 1
  const MacroB& macros = macro_b_of(m);
  return macros.single_block && (macros.control_1 & 1u) == 0 && (macros.control_2 & m_ov) == 0 &&
         m.modal.rows[macros.stop_group] != macros.inhibiting;
}

/// Stops after each NC block in single-block operation. INFERRED: macro blocks run together with the next NC block (23.5). Canned cycles
/// emit their own stops.
void stop_single_block(Emitter& m, bool was_hidden) {
  if (!may_stop(m) || m.block->word_count == 0 || m.canned_cycle_run.active() || m.cycling()) return;
  const bool returned = m.has_code({Function::return_program});
  const bool macro = returned || !macro_b_of(m).pending.empty() ||
                     m.has_code({Function::macro_call, Function::macro_modal, Function::macro_modal_off, Function::call_program});
  if (hidden(m) || (macro && !(returned && was_hidden)) || m.has_code({Function::program_end})) return;
  m.emit(Stop{false, StopReason::single_block});
}

}  // namespace

bool stops_each_block(const BlockContext& m) { return may_stop(m) && !hidden(m); }

Status check_values(BlockContext& m) {
  for (std::uint32_t i = 0; m.block->evaluates && i < m.block->word_count; ++i)
    if (Word& w = m.block->words[i]; w.expression && w.address != 0 && m.def.address(w.address).whole) w.value = std::round(w.value);
  return m.check_ranges();
}

void begin_words(BlockContext& m) {
  MacroB& macros = macro_b_of(m);
  macros.moved = macros.stops_reading = false;
  if (macros.single_block) macros.was_hidden = hidden(m);
  macros.pending.clear();
  give_back(m);
}

Result<bool> call_with_words(Interpreter& m) {
  const auto called = call_with_block(m);
  return !called || *called ? called : call_by_code(m);
}

Status one_g(const BlockContext& m) {
  bool found = false;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address != 'G') continue;
    if (found) return fail(alarm(AlarmId::illegal_address, w.where, 'G'));
    found = true;
  }
  return {};
}

void note_words(BlockContext& m) {
  ModalWords& words = macro_b_of(m).state.words;
  if (m.block->has_number) words.n = m.block->number;
  const auto take = [&](char letter, double& to) {
    if (const Word* const w = m.word(letter); w != nullptr) to = w->value;
  };
  take('D', words.d);
  take('E', words.e);
  take('F', words.f);
  take('H', words.h);
  take('M', words.m);
  // A spindle word with a number, such as S2=700 (11.1), also counts as the last S.
  for (std::uint32_t i = 0; (m.block->letters & m.letters.spindles) != 0 && i < m.block->word_count; ++i)
    if (const Word& w = m.block->words[i]; w.address != 0 && m.def.address(w.address).function == Function::spindle_word) words.s = w.value;
  take('T', words.t);
}

Status end_words(Interpreter& m) {
  MacroB& macros = macro_b_of(m);
  if (macros.single_block) stop_single_block(m, macros.was_hidden);
  KADR_TRY(call_pending(m));
  if (macros.moved && macros.state.active_modal_calls != 0) {
    const ModalCall& modal = macros.state.modal_calls[macros.state.active_modal_calls - 1u];
    if (!modal.each_block) {
      const Locals arguments = modal.arguments;
      KADR_TRY(call_modal(m, arguments));
    }
  }
  return {};
}

}  // namespace kadr::macro_b
