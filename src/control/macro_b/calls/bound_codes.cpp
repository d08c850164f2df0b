// Calls by codes and addresses that parameters bind to programs (spec/nct/23 23.3.4–23.3.8).

#include <cmath>

#include "base/tolerance.h"
#include "control/interpreter.h"
#include "control/macro_b/calls/calls.h"
#include "control/macro_b/dialect/blocks.h"

namespace kadr::macro_b {
namespace {

constexpr int letter_programs = 9030;  // the words A, B, C, S, T call the programs O9030 … O9034
constexpr int letter_variables = 195;  // the values of A, B, C, S, T are in #195 … #199
constexpr int ascii_variables = 191;   // the values of the letters of N1747 … are in #191 … #194
constexpr std::string_view letters_in_order = "ABCST";

/// Returns the number of the program that parameters bind to a G or M code; -1 if no program is bound to the code. `value`: the number of
/// the code.
int program_of(const std::vector<CodeRun>& runs, double value, const CodeRun** run = nullptr) {
  for (const CodeRun& r : runs) {
    const double k = std::round((value - r.start) / r.step);
    if (k < 0 || k >= r.count || std::fabs(r.start + k * r.step - value) > tol::whole_number) continue;
    if (run != nullptr) *run = &r;
    return r.program + static_cast<int>(k);
  }
  return -1;
}

/// Returns true if a word with this address and code may call the program bound to it, which depends on the programs that are being called.
/// Inside the program that a word has called, the same word makes no call (13.1, 23.3.4 … 23.3.7). Inside the program of another bound
/// word, a word makes a call only if N1755 #1 ENC permits this. ENC does not apply to a G code inside the macro of another G code (23.3.4).
bool may_call(const Interpreter& m, char address, std::int32_t code) {
  bool others = false;
  for (const CallFrame& frame : m.flow.frames()) {
    if (frame.called_by == 0) continue;
    if (frame.called_by == address && (frame.called_code == code || code < 0)) return false;
    others = others || frame.called_by != 'G' || address != 'G';
  }
  return !others || macro_b_of(m).settings.calls_inside_calls;
}

Status macro_by_code(Interpreter& m, const Word& w, int program, const CodeRun& run) {
  const Word* const first = m.block->words.data();
  if (w.written == 'M' && &w != first)
    // 23.3.5: before an M word that calls a macro, the block may have only N
    return fail(alarm(AlarmId::illegal_address, first->where, first->written));
  CallRequest request;
  const auto place = macro_b_of(m).programs.system(m, static_cast<std::uint32_t>(program), w.where);
  if (!place) return fail(place.error());
  request.place = *place;
  request.name = static_cast<std::uint32_t>(program);
  request.macro = true;
  request.called_by = w.written;
  request.called_code = w.code;
  Locals arguments;
  KADR_TRY(arguments_of(m, static_cast<std::uint32_t>(&w - m.block->words.data()), arguments));
  if (!run.modal) return call(m, request, arguments, w.where);
  MacroB& macros = macro_b_of(m);
  macros.keep_all();  // saved for an alarm, because a negative parameter makes the call modal, like a call by G66 or G66.1 (23.3.4)
  macros.state.modal_calls.resize(macros.state.active_modal_calls);
  macros.state.modal_calls.push_back(
      {request.place.reader, request.place.start, 1, request.name, macros.settings.modal_each_block, w.written, w.code, arguments});
  ++macros.state.active_modal_calls;
  return macros.settings.modal_each_block ? call_modal(m, arguments) : Status();
}

/// Removes a word from the block and requests the call of the subprogram bound to this word after the block.
void pend(BlockContext& m, Word& w, int program) {
  macro_b_of(m).pending.push_back({program, w.written, w.code, w.where});
  w.address = 0;
  m.block->altered = true;
}

/// Executes a word A, B, C, S, T, or a word of the four letters that parameters bind: stores its value in a common variable, and requests
/// the call of its subprogram after the block (23.3.7, 23.3.8).
bool letter_calls(Interpreter& m, Word& w) {
  const Settings& s = macro_b_of(m).settings;
  if (w.written > 'Z') return false;
  const std::size_t nth = letters_in_order.find(w.written);
  if (nth != std::string_view::npos && s.letters_call[nth]) {
    if (!may_call(m, w.written, -1)) return false;
    macro_b_of(m).variables.keep_common(m.journal, letter_variables + static_cast<int>(nth));
    macro_b_of(m).variables.set_common(letter_variables + static_cast<int>(nth), w.value);
    pend(m, w, letter_programs + static_cast<int>(nth));
    return true;
  }
  for (std::size_t i = 0; i < s.ascii.size(); ++i) {
    if (s.ascii[i] != w.written || s.ascii_programs[i] == 0 || !may_call(m, w.written, -1)) continue;
    macro_b_of(m).variables.keep_common(m.journal, ascii_variables + static_cast<int>(i));
    macro_b_of(m).variables.set_common(ascii_variables + static_cast<int>(i), w.value);
    pend(m, w, s.ascii_programs[i]);
    return true;
  }
  return false;
}

}  // namespace

Result<bool> call_by_code(Interpreter& m) {
  const Settings& s = macro_b_of(m).settings;
  if (!s.binds_codes || m.has_code({Function::macro_call, Function::macro_modal}))
    return false;  // in a block with G65 or G66, all other codes are arguments, so no code calls the program bound to it
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    Word& w = m.block->words[i];
    if (w.address == 0 || w.bare || (w.written != 'G' && w.written != 'M')) continue;
    const CodeRun* run = nullptr;
    const int program = program_of(w.written == 'G' ? s.g_macros : s.m_macros, w.value, &run);
    if (program < 0 || !may_call(m, w.written, w.code)) continue;
    KADR_TRY(macro_by_code(m, w, program, *run));
    return true;
  }
  KADR_TRY(check_values(m));
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    Word& w = m.block->words[i];
    if (w.address == 0 || w.bare || w.written == 'G') continue;
    if (w.written != 'M') (void)letter_calls(m, w);
    else if (const int sub = program_of(s.m_programs, w.value); sub >= 0 && may_call(m, 'M', w.code)) pend(m, w, sub);
  }
  if (!macro_b_of(m).pending.empty()) m.note_addresses();
  return false;
}

/// Calls the pending subprograms. INFERRED: they run in the order in which their words are written. The calls are therefore entered in
/// reverse order, because the call that is entered last runs first.
Status call_pending(Interpreter& m) {
  MacroB& macros = macro_b_of(m);
  for (; !macros.pending.empty(); macros.pending.pop_back()) {
    const PendingCall& pending = macros.pending.back();
    CallRequest request;
    const auto place = macros.programs.system(m, static_cast<std::uint32_t>(pending.program), pending.where);
    if (!place) return fail(place.error());
    request.place = *place;
    request.name = static_cast<std::uint32_t>(pending.program);
    request.called_by = pending.letter;
    request.called_code = pending.code;
    KADR_TRY(call(m, request, {}, pending.where));
  }
  return {};
}

}  // namespace kadr::macro_b
