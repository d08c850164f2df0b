// Interrupt macro: M96, M97, the signal CP_MINT (spec/nct/23 23.4). For the rest of control.

#include "control/macro_b/calls/interrupt.h"

#include <utility>

#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"
#include "control/macro_b/calls/calls.h"
#include "control/nct/nct.h"

namespace kadr::nct {
namespace {

bool signal_on(const Nct& nct) {
  const auto found = nct.signals.find(std::string(interrupt_signal));
  return found != nct.signals.end() && found->second != 0;
}

bool asked(Nct& nct) {
  const bool rose = std::exchange(nct.signal_rose, false);
  return nct.settings.interrupt_edge ? rose : signal_on(nct);
}

/// The code is the machine's: N1758 #0 USD=0, or #4 MCD says that other codes do it.
bool is_free(const Nct& nct, int code, int own) { return !nct.settings.interrupts || (nct.settings.interrupt_own_codes && code != own); }

/// A running interrupt macro is aborted (13.1). INFERRED: as by M99, the calls it made included.
Status abort_interrupt(Interpreter& m, const Call& call) {
  Nct& nct = nct_of(m);
  while (nct.interrupted.active && m.flow.depth() != 0) {
    m.flow.innermost()->left = 1;
    KADR_TRY(return_from(m, call));
  }
  return {};
}

}  // namespace

Result<bool> interrupt_code(Interpreter& m, const Call& call) {
  const Settings& s = nct_of(m).settings;
  if (!s.interrupts || !s.interrupt_own_codes) return false;
  const int code = call.word->code / 10;
  if (code != s.interrupt_on && code != s.interrupt_off) return false;
  KADR_TRY(code == s.interrupt_on ? functions::interrupt_on(m, call) : functions::interrupt_off(m, call));
  return true;
}

Result<bool> call_interrupt(Interpreter& m, BlockMoment moment) {
  Nct& nct = nct_of(m);
  if (!nct.state.interrupt_program || nct.interrupted.active) return false;
  if (nct.settings.interrupt_at_end != (moment == BlockMoment::end) || !asked(nct)) return false;
  CallFrame frame;
  frame.kind = CallFrame::Kind::interrupt;
  frame.left = 1;
  frame.caller = m.origin;
  frame.modal_calls = nct.state.active_modal_calls;
  frame.opened_level = !nct.settings.interrupt_keeps_locals;
  if (moment == BlockMoment::start) m.flow.jump(m.block->position);  // it is read again after the macro
  KADR_TRY(m.flow.call_at(nct.state.interrupt_program->reader, nct.state.interrupt_program->start, frame, m.block->where));
  if (frame.opened_level) nct.variables.open_level(no_locals());
  nct.interrupted = {true, m.modal, nct.state.words, m.transform};
  nct.interrupted_cycles = {nct.state.drilling, nct.state.turning, nct.state.modal_calls, nct.state.active_modal_calls};
  nct.state.active_modal_calls = 0;
  return true;
}

/// Plain M99 brings the modal state back; what it says is in force again (23.4). M99 P does not.
void Nct::end_interrupt(Interpreter& m, bool restore) {
  interrupted.active = false;
  signal_rose = false;  // one during the macro does not count
  if (!restore) return;
  m.modal = interrupted.modal;
  state.words = interrupted.words;
  state.drilling = interrupted_cycles.drilling;
  state.turning = interrupted_cycles.turning;
  state.modal_calls = std::move(interrupted_cycles.modal_calls);
  state.active_modal_calls = interrupted_cycles.active_modal_calls;
  m.transform = interrupted.transform;
  m.position.programmed = m.transform.to_programmed(before_transform(m));
  m.change_frames();
}

}  // namespace kadr::nct

namespace kadr::functions {

/// M96 P, M96 <file>: from now on the signal calls that program. N1758 #5 SYM = 0: it is looked for beside the main program, wherever M96
/// stands (23.4).
Status interrupt_on(Interpreter& m, const Call& call) {
  nct::Nct& nct = nct_of(m);
  if (nct::is_free(nct, call.word->code / 10, nct.settings.interrupt_on)) return nct::machine_code(m, call);
  if (m.def.tells_of_ends()) m.tell_machine(call.word->code);
  nct.signal_rose = false;  // INFERRED: an edge before it does not count
  if (m.block->file_name.end != 0) {
    const auto place = nct.programs.by_name(m, m.block->text_of(m.block->file_name), m.block->file_name, nct::Beside::main_program);
    if (!place) return fail(place.error());
    nct.state.interrupt_program = *place;
    return {};
  }
  if (!m.has('P')) return fail(alarm(AlarmId::word_missing, call.where, 'P', call.row->code));
  const auto number = m.whole('P', 0, 99'999'999);
  if (!number) return fail(number.error());
  const auto place = nct.settings.interrupt_in_system ? nct.programs.system(m, *number, m.where('P'))
                                                      : nct.programs.by_number(m, *number, m.where('P'), nct::Beside::main_program);
  if (!place) return fail(place.error());
  nct.state.interrupt_program = *place;
  return {};
}

Status interrupt_off(Interpreter& m, const Call& call) {
  if (nct::is_free(nct_of(m), call.word->code / 10, nct_of(m).settings.interrupt_off)) return nct::machine_code(m, call);
  if (m.def.tells_of_ends()) m.tell_machine(call.word->code);
  nct_of(m).state.interrupt_program.reset();
  return nct::abort_interrupt(m, call);
}

}  // namespace kadr::functions
