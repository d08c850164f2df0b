// M97 and M96 of the Haas: subprogram calls to a block of the same program, and jumps that depend on an input signal (spec/haas 3.1, 3.4).
// Used by control/functions; tested by tests/cases/haas.

#include <cmath>

#include "control/functions/functions.h"
#include "control/macro_b/calls/calls.h"
#include "control/macro_b/macro_b.h"
#include "control/macro_b/statements/messages.h"

namespace kadr::functions {

using macro_b::CallRequest;

/// M97 P L (spec/haas 3.1): calls the blocks of the same program from block P up to M99, L times. These blocks use the caller's local
/// variables.
Status call_local(Interpreter& m, const Call& call) {
  const Word* const p = m.word('P');
  if (p == nullptr) return fail(alarm(AlarmId::call_without_program, call.where, call.row->code));
  const auto times = macro_b::repeats_of(m);
  if (!times) return fail(times.error());
  const auto start = macro_b::block_numbered(m, p->value, p->where);
  if (!start) return fail(start.error());
  CallRequest request;
  request.place = {m.program().reader(), *start};
  request.name = static_cast<std::uint32_t>(macro_b_of(m).state.words.o);
  request.times = *times;
  return macro_b::call(m, request, {}, call.where);
}

/// M96 P Q (spec/haas 3.4): jumps to block P if the input signal with number Q is 0. INFERRED: a signal that the set-up does not list is 0.
Status jump_by_input(Interpreter& m, const Call& call) {
  for (const char letter : {'P', 'Q'})
    if (!m.has(letter)) return fail(alarm(AlarmId::word_missing, call.where, letter, call.row->code));
  constexpr double max_inputs = 63;
  // The reader has scaled Q like a length. Q of M96 is the number of a signal here, so the scaling is undone.
  const double input = std::round(m.value('Q') * std::pow(10.0, m.word('Q')->counted));
  if (!(input >= 0 && input <= max_inputs)) return fail(alarm(AlarmId::value_out_of_range, m.where('Q'), 'Q', input));
  const auto& inputs = macro_b_of(m).plc_in;
  const auto number = static_cast<std::size_t>(input);
  if (number < inputs.size() && inputs[number] != 0) return {};
  return macro_b::go_to_block_again(m, m.value('P'), m.where('P'));
}

}  // namespace kadr::functions
