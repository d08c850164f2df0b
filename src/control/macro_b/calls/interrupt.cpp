// Interrupt macro: M96, M97, the signal CP_MINT (spec/nct/23 23.4). Used by the rest of control.

#include "control/macro_b/calls/interrupt.h"

#include <utility>

#include "control/functions/functions.h"
#include "control/macro_b/calls/calls.h"
#include "control/macro_b/macro_b.h"

namespace kadr::macro_b {
namespace {

bool signal_on(const MacroB& macros) {
  const auto found = macros.signals.find(std::string(interrupt_signal));
  return found != macros.signals.end() && found->second != 0;
}

bool is_requested(MacroB& macros) {
  const bool rose = std::exchange(macros.signal_rose, false);
  return macros.settings.interrupt_edge ? rose : signal_on(macros);
}

/// Returns true if the M code `code` (M96 or M97) is passed to the machine: the interrupt macro is off (N1758 #0 USD=0), or N1758 #4 MCD
/// assigns other M codes to the interrupt macro. `own`: the assigned M code.
bool is_free(const MacroB& macros, int code, int own) {
  return !macros.settings.interrupts || (macros.settings.interrupt_own_codes && code != own);
}

/// Aborts a running interrupt macro (13.1). INFERRED: the macro and the programs that it has called end as with M99.
Status abort_interrupt(Interpreter& m, const Call& call) {
  MacroB& macros = macro_b_of(m);
  while (macros.interrupted.active && m.program().depth() != 0) {
    m.flow.innermost()->left = 1;
    KADR_TRY(return_from(m, call));
  }
  return {};
}

}  // namespace

Result<bool> interrupt_code(Interpreter& m, const Call& call) {
  const Settings& s = macro_b_of(m).settings;
  if (!s.interrupts || !s.interrupt_own_codes) return false;
  const int code = call.word->code / 10;
  if (code != s.interrupt_on && code != s.interrupt_off) return false;
  KADR_TRY(code == s.interrupt_on ? functions::interrupt_on(m, call) : functions::interrupt_off(m, call));
  return true;
}

Result<bool> call_interrupt(Interpreter& m, BlockMoment moment) {
  MacroB& macros = macro_b_of(m);
  if (!macros.state.interrupt_program || macros.interrupted.active) return false;
  if (macros.settings.interrupt_at_end != (moment == BlockMoment::end) || !is_requested(macros)) return false;
  CallFrame frame;
  frame.kind = CallFrame::Kind::interrupt;
  frame.left = 1;
  frame.caller = m.origin;
  frame.modal_calls = macros.state.active_modal_calls;
  frame.opened_level = !macros.settings.interrupt_keeps_locals;
  if (moment == BlockMoment::start) m.flow.jump(m.block->position);  // the interrupted block is read again after the macro
  KADR_TRY(m.flow.call_at(macros.state.interrupt_program->reader, macros.state.interrupt_program->start, frame, m.block->where));
  if (frame.opened_level) macros.variables.open_level(no_locals());
  macros.interrupted = {true, m.modal, macros.state.words, m.transform, macros.state.modal_calls, macros.state.active_modal_calls};
  macros.keep_cycles();
  macros.state.active_modal_calls = 0;
  return true;
}

/// Ends the interrupt macro. M99 without P restores the modal state of the interrupted block (`restore` is true); M99 P does not (23.4).
void MacroB::end_interrupt(Emitter& m, bool restore) {
  interrupted.active = false;
  signal_rose = false;  // an edge of the signal CP_MINT during the macro has no effect
  if (!restore) return;
  m.modal = interrupted.modal;
  state.words = interrupted.words;
  bring_cycles_back();
  state.modal_calls = std::move(interrupted.modal_calls);
  state.active_modal_calls = interrupted.active_modal_calls;
  m.transform = interrupted.transform;
  m.position.programmed = m.transform.to_programmed(before_transform(m));
  m.change_frames();
}

}  // namespace kadr::macro_b

namespace kadr::functions {

/// M96 P, M96 <file>: enables the program as interrupt macro, which the signal CP_MINT calls. With N1758 #5 SYM = 0 the program is searched
/// in the folder of the main program, even if M96 is in a subprogram in another folder (23.4).
Status interrupt_on(Interpreter& m, const Call& call) {
  macro_b::MacroB& macros = macro_b_of(m);
  if (macro_b::is_free(macros, call.word->code / 10, macros.settings.interrupt_on)) return m.dialect->machine_code(m, call);
  if (m.def.reports_program_ends()) m.report_to_machine(call.word->code);
  macros.signal_rose = false;  // INFERRED: an edge of the signal CP_MINT before M96 has no effect
  if (m.block->file_name.end != 0) {
    const auto place = macros.programs.by_name(m, m.block->text_of(m.block->file_name), m.block->file_name, macro_b::NextTo::main_program);
    if (!place) return fail(place.error());
    macros.state.interrupt_program = *place;
    return {};
  }
  if (!m.has('P')) return fail(alarm(AlarmId::word_missing, call.where, 'P', call.row->code));
  const auto number = m.whole('P', 0, 99'999'999);
  if (!number) return fail(number.error());
  const auto place = macros.settings.interrupt_in_system
                         ? macros.programs.system(m, *number, m.where('P'))
                         : macros.programs.by_number(m, *number, m.where('P'), macro_b::NextTo::main_program);
  if (!place) return fail(place.error());
  macros.state.interrupt_program = *place;
  return {};
}

Status interrupt_off(Interpreter& m, const Call& call) {
  if (macro_b::is_free(macro_b_of(m), call.word->code / 10, macro_b_of(m).settings.interrupt_off)) return m.dialect->machine_code(m, call);
  if (m.def.reports_program_ends()) m.report_to_machine(call.word->code);
  macro_b_of(m).state.interrupt_program.reset();
  return macro_b::abort_interrupt(m, call);
}

}  // namespace kadr::functions
