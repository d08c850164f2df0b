// Macro and subprogram calls: arguments, levels, modal calls, codes and addresses bound to programs (spec/nct/23 23.3, 14.4). Used by the
// rest of control.

#include "control/macro_b/calls/calls.h"

#include <algorithm>
#include <cmath>

#include "base/code_literals.h"
#include "base/tolerance.h"
#include "control/functions/after_fault.h"
#include "control/functions/functions.h"
#include "control/macro_b/dialect/blocks.h"
#include "control/macro_b/statements/messages.h"

namespace kadr::macro_b {
namespace {

constexpr std::uint32_t max_repeats = 99'999'999;

/// Finds the program that the word P or the <name> of the block names.
Result<CallRequest> named_program(Interpreter& m, const Call& code, bool name_allowed) {
  CallRequest request;
  if (m.block->file_name.end != 0) {
    // 23.3: of the codes that call a macro, only G65 accepts a file name in place of P
    if (!name_allowed) return fail(alarm(AlarmId::word_missing, code.where, 'P', code.row->code));
    const auto place = macro_b_of(m).programs.by_name(m, m.block->text_of(m.block->file_name), m.block->file_name);
    if (!place) return fail(place.error());
    request.place = *place;
    return request;
  }
  const Word* const p = m.word('P');
  if (p == nullptr) return fail(alarm(AlarmId::call_without_program, code.where, code.row->code));
  auto number = m.whole('P', 0, 99'999'999);
  if (!number) return fail(number.error());
  constexpr std::uint32_t four_digits = 10'000;
  const bool counts = m.def.behaviour.repeats_in_program_number && code.row->function == Function::call_program && !m.has('L');
  if (counts && *number >= four_digits) {  // spec/fanuc 9.1: P51002 means O1002, executed five times
    request.times = *number / four_digits;
    *number %= four_digits;
  }
  request.name = *number;
  const auto place = macro_b_of(m).programs.by_number(m, *number, p->where);
  if (!place) return fail(place.error());
  request.place = *place;
  return request;
}

std::uint32_t index_of(const BlockContext& m, const Word* word) { return static_cast<std::uint32_t>(word - m.block->words.data()); }

/// Discards the data of a call that has ended: the level of local variables, the saved arguments and the modal calls of the called program.
void close_call(MacroB& macros, const CallFrame& frame, std::size_t depth) {
  if (frame.kind == CallFrame::Kind::macro || (frame.kind == CallFrame::Kind::interrupt && frame.opened_level))
    macros.variables.close_level();
  if (!macros.repeated_arguments.empty() && macros.repeated_arguments.back().first == depth) macros.repeated_arguments.pop_back();
  macros.state.active_modal_calls = std::min<std::uint8_t>(frame.modal_calls, static_cast<std::uint8_t>(macros.state.modal_calls.size()));
}

}  // namespace

Result<std::uint32_t> repeats_of(const BlockContext& m) {
  const Word* const l = m.word('L');
  if (l == nullptr) return 1u;
  // 23.1.1: the number of repetitions L is rounded if an expression gives it
  const double times = l->expression ? std::round(l->value) : l->value;
  if (times != std::floor(times)) return fail(alarm(AlarmId::word_not_integer, l->where, 'L', times));
  if (!(times >= 1 && times <= max_repeats)) return fail(alarm(AlarmId::value_out_of_range, l->where, 'L', times));
  return static_cast<std::uint32_t>(times);
}

void leave_call(Interpreter& m) {
  const CallFrame* const top = m.flow.innermost();
  if (top == nullptr) return;
  const CallFrame frame = *top;
  const std::size_t depth = m.program().depth();
  m.flow.abandon(std::nullopt);
  close_call(macro_b_of(m), frame, depth);
  if (frame.kind == CallFrame::Kind::interrupt) macro_b_of(m).end_interrupt(m, true);
}

Status call(Interpreter& m, const CallRequest& request, const Locals& arguments, Span where) {
  MacroB& macros = macro_b_of(m);
  CallFrame frame;
  frame.kind = request.macro ? CallFrame::Kind::macro : CallFrame::Kind::subprogram;
  frame.name = request.name;
  frame.left = request.times;
  frame.caller = m.origin;
  frame.modal_calls = macros.state.active_modal_calls;
  frame.called_by = request.called_by;
  frame.called_code = request.called_code;
  KADR_TRY(m.flow.call_at(request.place.reader, request.place.start, frame, where));
  macros.state.words.o = request.name;
  if (!request.macro) return {};
  macros.variables.open_level(arguments);
  if (request.times > 1) macros.repeated_arguments.emplace_back(m.program().depth(), arguments);
  return {};
}

Status call_modal(Interpreter& m, const Locals& arguments) {
  MacroB& macros = macro_b_of(m);
  const ModalCall& modal = macros.state.modal_calls[macros.state.active_modal_calls - 1u];
  CallRequest request;
  request.place = {modal.reader, modal.start};
  request.name = modal.name;
  request.times = modal.times;
  request.macro = true;
  request.called_by = modal.called_by;
  request.called_code = modal.called_code;
  KADR_TRY(call(m, request, arguments, m.block->where));
  --macros.state.active_modal_calls;  // while the macro runs, only modal calls that were programmed before this call are in force
  return {};
}

Status return_from(Interpreter& m, const Call& code) {
  MacroB& macros = macro_b_of(m);
  const Word* const p = m.word('P');
  if (p != nullptr && !(p->value >= 0 && p->value <= max_repeats)) return fail(alarm(AlarmId::value_out_of_range, p->where, 'P', p->value));
  CallFrame* const top = m.flow.innermost();
  if (p != nullptr && m.def.behaviour.returns_to_own_block) return go_to_block_again(m, p->value, p->where);
  if (top == nullptr) {  // 14.4.4: M99 in the main program is a jump
    if (p != nullptr) return go_to_block_again(m, p->value, p->where);
    return m.begin_again(code.where);
  }
  std::uint32_t passes = top->left;
  if (m.has('L')) {  // 14.4.3, INFERRED: L of M99 is the number of executions after the first
    const auto k = m.whole('L', 0, max_repeats);
    if (!k) return fail(k.error());
    const std::uint32_t total = *k + 1;
    passes = total > top->done ? total - top->done + 1 : 1;
  }
  top->left = passes;
  shorten_after_fault(m.report, m.flow);
  passes = top->left;
  const auto return_to = p != nullptr ? static_cast<std::int32_t>(p->value) : top->return_to;
  if (passes == 1 && return_to >= 0 && !m.flow.caller_has(static_cast<std::uint32_t>(return_to)))
    return fail(alarm(AlarmId::block_not_found, p != nullptr ? p->where : code.where, double(return_to)));
  top->return_to = return_to;
  const bool opened_level = top->kind == CallFrame::Kind::macro;
  const std::size_t depth = m.program().depth();
  const auto left = m.flow.end_subprogram(code.where);
  if (!left) return fail(left.error());
  if (!*left) {  // the subprogram is to be repeated, so the call does not end yet
    if (opened_level && !m.def.behaviour.repeats_keep_locals) macros.variables.locals() = macros.repeated_arguments.back().second;
    return {};
  }
  const CallFrame& frame = **left;
  close_call(macros, frame, depth);
  if (frame.kind == CallFrame::Kind::interrupt) macros.end_interrupt(m, frame.return_to < 0);
  if (frame.return_to >= 0) return go_to_block(m, frame.return_to, p != nullptr ? p->where : code.where);
  return {};
}

}  // namespace kadr::macro_b

namespace kadr::functions {

using macro_b::CallRequest;

/// G65 P L arguments, G65 <file> (23.3.1): calls a macro once, or L times.
Status macro_call(Interpreter& m, const Call& call) {
  auto request = macro_b::named_program(m, call, true);
  if (!request) return fail(request.error());
  const auto times = macro_b::repeats_of(m);
  if (!times) return fail(times.error());
  request->times = *times;
  request->macro = true;
  Locals arguments;
  KADR_TRY(macro_b::arguments_of(m, macro_b::index_of(m, call.word), arguments));
  return macro_b::call(m, *request, arguments, call.where);
}

/// G66 P L arguments: calls the macro after each movement (23.3.2). G66.1: calls the macro with the words of each block as arguments, from
/// the block of G66.1 on (23.3.3).
Status macro_modal(Interpreter& m, const Call& call) {
  constexpr std::size_t max_modal_calls = 16;
  auto request = macro_b::named_program(m, call, false);
  if (!request) return fail(request.error());
  const auto times = macro_b::repeats_of(m);
  if (!times) return fail(times.error());
  Locals arguments;
  KADR_TRY(macro_b::arguments_of(m, macro_b::index_of(m, call.word), arguments));
  macro_b::MacroB& macros = macro_b_of(m);
  if (macros.state.modal_calls.size() >= max_modal_calls) return fail(alarm(AlarmId::call_too_deep, call.where, double{max_modal_calls}));
  // INFERRED: modal calls that are not in force in this macro are deleted
  macros.state.modal_calls.resize(macros.state.active_modal_calls);
  macros.state.modal_calls.push_back(
      {request->place.reader, request->place.start, *times, request->name, call.row->arg == 66.1_g, 0, -1, arguments});
  ++macros.state.active_modal_calls;
  return call.row->arg == 66.1_g ? macro_b::call_modal(m, arguments) : Status();
}

/// G67: cancels the modal call that was programmed last.
Status macro_modal_off(Emitter& m, const Call& call) {
  macro_b::MacroB& macros = macro_b_of(m);
  if (!macros.state.modal_calls.empty()) macros.state.modal_calls.pop_back();
  macros.state.active_modal_calls =
      std::min<std::uint8_t>(macros.state.active_modal_calls, static_cast<std::uint8_t>(macros.state.modal_calls.size()));
  (void)call;
  return {};
}

/// M98 P L, M98 <file> L (14.4.2): calls a subprogram, which uses the caller's local variables.
Status call_program(Interpreter& m, const Call& call) {
  auto request = macro_b::named_program(m, call, true);
  if (!request) return fail(request.error());
  const auto times = macro_b::repeats_of(m);
  if (!times) return fail(times.error());
  if (m.has('L')) request->times = *times;
  return macro_b::call(m, *request, {}, call.where);
}

Status return_program(Interpreter& m, const Call& call) { return macro_b::return_from(m, call); }

}  // namespace kadr::functions
