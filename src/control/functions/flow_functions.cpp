// The functions for ends, calls, returns and repetitions.

#include "control/functions/after_fault.h"
#include "control/functions/functions.h"
#include "control/functions/section_calls.h"

namespace kadr {
namespace {

/// Ends the program and puts the control's end-of-program codes in force. Fails if a call or a repetition is open.
Status end_program(Interpreter& m, Span where) {
  if (m.program().depth() != 0) {
    const CallFrame& top = m.flow.frames().back();
    if (top.kind == CallFrame::Kind::repetition) return fail(alarm(AlarmId::repeat_end_missing, where, double(top.caller.line)));
    if (m.def.has_sections()) return fail(alarm(AlarmId::subprogram_end_missing, where, double(top.name)));
  }
  if (!m.def.has_lines_alone()) m.flow.end();
  if (m.dialect->end_program(m)) return {};
  for (const std::int32_t row_index : m.def.end_codes) {
    const CodeRow& row = m.def.codes[static_cast<std::size_t>(row_index)];
    const bool switches_off = (row.function == Function::spindle_stop && m.modal.spindle != SpindleDir::stop) ||
                              (row.function == Function::coolant_off && (m.modal.flood || m.modal.mist));
    // The stops of spindle and coolant are emitted, because lines that are sent later run with both switched off.
    const bool emitted = m.def.has_lines_alone() && switches_off;
    const std::size_t silent = m.batch->size();
    (void)handler_of(row.function)(m, {&row, nullptr, where});
    if (row.letter == 'M' && !emitted)
      m.batch->cut(silent);  // M2 is emitted as one action, so the separate actions that switch off spindle and coolant are removed
    if (row.group != 0 && row.modal) m.modal.rows[row.group] = static_cast<std::int16_t>(row_index);
  }
  return {};
}

Status leave_subprogram(Interpreter& m, Span where) {
  shorten_after_fault(m.report, m.flow);
  const auto left = m.flow.end_subprogram(where);
  if (!left) return fail(left.error());
  if (!*left) return {};
  restore_work_offset(m, **left);
  const auto then = (*left)->then;  // codes of the calling block that are still to be executed; they may end a subprogram too
  for (const std::int16_t row : then) {
    if (row < 0) break;
    const CodeRow& code = m.def.codes[static_cast<std::size_t>(row)];
    KADR_TRY(handler_of(code.function)(m, {&code, nullptr, where}));
    if (code.function == Function::subprogram_end) break;  // in `M17 M2` the M2 only ends the section of subprograms
  }
  return {};
}

}  // namespace

namespace functions {

Status program_end(Interpreter& m, const Call& call) { return end_program(m, call.where); }
Status tape_end(Interpreter& m, const Call& call) { return end_program(m, call.where); }

Status repeat_program(Interpreter& m, const Call& call) { return m.begin_again(call.where); }

/// M98 P (Mach3): calls a subprogram L or Q times.
Status call_subprogram(Interpreter& m, const Call& call) {
  if (!m.has('P')) return fail(alarm(AlarmId::word_missing, call.where, 'P', "M98"));
  const auto name = m.whole('P', 0, 999'999'999);
  if (!name) return fail(name.error());
  if (m.has('L') && m.has('Q')) return fail(alarm(AlarmId::not_together, m.where('Q'), "L", "Q"));
  std::uint32_t times = 1;
  for (const char letter : {'L', 'Q'})
    if (m.has(letter)) {
      const auto count = m.whole(letter, 1, 99'999'999);
      if (!count) return fail(count.error());
      times = *count;
    }
  return m.flow.call(*name, times, m.origin, call.where);
}

/// M99: returns to the caller. In the main program M99 starts the main program again (spec/mach3 1).
Status subprogram_return(Interpreter& m, const Call& call) {
  if (m.program().depth() == 0) return m.begin_again(call.where);
  return leave_subprogram(m, call.where);
}

/// M17: ends one pass of a subprogram (2С42 6.3.6).
Status subprogram_end(Interpreter& m, const Call& call) { return leave_subprogram(m, call.where); }

/// H: executes the blocks after this one, up to M20, the given number of times (2С42 6.4.6).
Status repeat_word(Interpreter& m, const Call& call) {
  const auto times = m.whole('H', 1, 9999);
  if (!times) return fail(times.error());
  return m.flow.repeat(*times, m.origin, call.where);
}

Status repetition_end(Interpreter& m, const Call& call) {
  shorten_after_fault(m.report, m.flow);
  return m.flow.end_repetition(call.where);
}

/// L: calls a subprogram or a canned cycle.
Status call_word(Interpreter& m, const Call& call) { return call_section(m, call); }

}  // namespace functions
}  // namespace kadr
