// Executes the characters and blocks that structure a file: '%', sections of subprograms, labels.

#include "control/functions/section_calls.h"
#include "control/interpreter.h"

namespace kadr {

/// Returns the location of the letter O in the block's label. If the program writes the label with another letter, returns the location of
/// the whole block.
Span Interpreter::label_span() const {
  const std::size_t from = block->has_number ? block->number_where.end : block->where.begin;
  const std::size_t at = block->text.find(def.grammar.label_address, from);
  if (at >= block->where.end) return block->where;
  return {static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(at + 1)};
}

/// Executes a block that marks where programs and subprograms start: '%', the start of a section of subprograms, or a label.
Status Interpreter::structure() {
  switch (block->marker) {
    case Marker::program_start:
      if (def.grammar.percent_encloses) {
        const auto done = dialect->sign_of_file(*this);
        if (!done) return fail(done.error());
        flow.set_started(true);
        return {};
      }
      if (flow.started() && !skipping_section && flow.depth() == 0 && def.behaviour.ends_reading) {
        warn(warning(AlarmId::end_missing, block->where));
        flow.end();  // the tape may hold several programs: the blocks after this one are the next program
      }
      flow.set_started(true);
      skipping_section = false;
      start_block = flow.blocks();
      return {};
    case Marker::section:
      if (flow.depth() != 0) return fail(alarm(AlarmId::subprogram_end_missing, block->where, double(flow.frames().back().name)));
      skipping_section = true;
      return {};
    case Marker::label:
      if (def.behaviour.label_is_number && flow.blocks() != start_block + 1)  // spec/gost 1: the program number must follow `%` directly
        return fail(alarm(AlarmId::program_number_place, label_span(), double(block->label)));
      if (def.grammar.programs_by_label) KADR_TRY(next_program());
      if (flow.ended()) return {};
      dialect->note_line(*this);
      flow.set_started(true);
      if (flow.depth() == 0) flow.pass_label(block->label);
      return {};
    default: break;
  }
  constexpr std::uint8_t digits_of_label = 5;  // N in a section of subprograms always has five digits (2С42 6.3.5)
  if (skipping_section && block->has_number && block->number_digits != digits_of_label)
    return fail(alarm(AlarmId::too_few_digits, block->number_where, 'N', double(block->number_digits), double(digits_of_label)));
  if (skipping_section) note_section();
  if (skipping_section || flow.started() || block->empty()) return {};
  flow.set_started(true);
  if (!def.grammar.program_start_required) return {};
  return fail(alarm(AlarmId::program_start_missing, {block->where.begin, block->where.begin + 1}));
}

/// Handles a label O… in a file that contains several programs. The label is the end of the program that is being executed (spec/fanuc
/// 1.1).
Status Interpreter::next_program() {
  const CallFrame* const top = flow.innermost();
  if (top == nullptr) {
    if (block->position.offset > flow.program_file().first_block().offset) {
      warn(warning(AlarmId::end_missing, block->where));
      flow.end();
    }
    return {};
  }
  const bool own = block->label == top->name || block->position.offset == top->start.offset || top->start.offset == 0;
  return own ? Status() : fail(alarm(AlarmId::subprogram_end_missing, block->where, double(top->name)));
}

/// Warns at the first block of a subprogram if a canned cycle has the same number. A call of this number executes the cycle, so the
/// subprogram cannot be called (2С42 6.7.1).
void Interpreter::note_section() {
  constexpr std::uint32_t blocks_a_subprogram = 1000;  // N02001 is subprogram 02, block 001 (2С42 6.3.5)
  const std::uint32_t number = block->number / blocks_a_subprogram;
  if (block->has_number && called_cycle(def, number) != nullptr) dialect->note_shadowed(*this, number, block->number_where);
}

}  // namespace kadr
