#include "control/nct/interrupt.h"

#include "control/functions.h"
#include "control/nct/calls.h"
#include "control/nct/nct.h"

namespace kadr::nct {
namespace {

constexpr const char* interrupt_signal = "CP_MINT";

bool asked(Nct& nct) {
  const auto found = nct.signals.find(interrupt_signal);
  const bool on = found != nct.signals.end() && found->second != 0;
  const bool rose = on && !nct.signal_was_on;
  nct.signal_was_on = on;
  return nct.settings.interrupt_edge ? rose : on;
}

}  // namespace

Result<bool> call_interrupt(Machinery& m, BlockMoment moment) {
  Nct& nct = *m.nct;
  if (!nct.interrupt_program || nct.interrupted.active) return false;
  if (nct.settings.interrupt_at_end != (moment == BlockMoment::end) || !asked(nct)) return false;
  CallFrame frame;
  frame.kind = CallFrame::Kind::interrupt;
  frame.left = 1;
  frame.caller = m.origin;
  frame.modal_calls = nct.active_modal_calls;
  frame.opened_level = !nct.settings.interrupt_keeps_locals;
  if (moment == BlockMoment::start) m.flow.jump(m.block->position);  // it is read again behind the macro
  KADR_TRY(m.flow.call_at(nct.interrupt_program->reader, nct.interrupt_program->start, frame, m.block->where));
  if (frame.opened_level) nct.variables.open_level(no_locals());
  nct.active_modal_calls = 0;
  nct.interrupted = {true, m.modal, nct.state.words};
  return true;
}

/// Plain M99 brings the modal state back; what it says is in force again (23.4). M99 P does not.
void Nct::end_interrupt(Machinery& m, bool restore) {
  interrupted.active = false;
  if (!restore) return;
  m.modal = interrupted.modal;
  state.words = interrupted.words;
  m.change_frames();
}

}  // namespace kadr::nct

namespace kadr::functions {

/// M96 P, M96 <file>: from now on the signal calls that program.
Status interrupt_on(Machinery& m, const Call& call) {
  nct::Nct& nct = *m.nct;
  if (!nct.settings.interrupts) return nct::machine_code(m, call);  // N1758 #0 USD=0: the code is the machine's
  if (m.block->file_name.end != 0) {
    const auto place = nct.programs.by_name(m, m.block->text_of(m.block->file_name), m.block->file_name);
    if (!place) return fail(place.error());
    nct.interrupt_program = *place;
    return {};
  }
  if (!m.has('P')) return fail(alarm(AlarmId::word_missing, call.where, 'P', call.row->code));
  const auto number = m.whole('P', 0, 99'999'999);
  if (!number) return fail(number.error());
  const auto place = nct.settings.interrupt_in_system ? nct.programs.system(m, *number, m.where('P')) : nct.programs.by_number(m, *number, m.where('P'));
  if (!place) return fail(place.error());
  nct.interrupt_program = *place;
  return {};
}

Status interrupt_off(Machinery& m, const Call& call) {
  if (!m.nct->settings.interrupts) return nct::machine_code(m, call);
  m.nct->interrupt_program.reset();
  return {};
}

}  // namespace kadr::functions
