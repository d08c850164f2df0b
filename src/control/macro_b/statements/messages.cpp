// Messages that a program shows by assigning #3000, #3006, #3106 or #3107 (spec/nct/23 23.1.8). Used by control/macro_b/calls/calls,
// control/macro_b/statements/statements.

#include "control/macro_b/statements/messages.h"

#include <fmt/core.h>

#include <cmath>

#include "control/macro_b/macro_b.h"
#include "control/macro_b/output/output.h"
#include "control/variable_reader.h"
#include "lang/expression/expression.h"

namespace kadr::macro_b {
namespace {

constexpr int stop_base = 5000;

std::string text_of(BlockContext& m) {
  if (m.block->comments.empty()) return {};
  Span all;
  return m.program().shown(m.block->text_of(m.block->comments.front()), all);
}

/// Returns the message number before the text, which has at most three digits; 0 if the statement has no number.
Result<int> number_of(Emitter& m, const Statement& s) {
  if (!s.value) return 0;
  const auto value = evaluate(*m.block, s.value, VariableReader{m});
  if (!value) return fail(value.error());
  const double nearest = is_vacant(*value) ? 0 : std::round(*value);
  if (!(nearest >= 0 && nearest <= 999)) return fail(alarm(AlarmId::message_number, s.where, *value));
  return static_cast<int>(nearest);
}

/// Executes #3000: the program stops with alarm ii4nnn00, where ii is the channel and nnn the number.
Status program_alarm(BlockContext& m, const Statement& s, int number) {
  const int alarm_base = static_cast<int>(m.def.behaviour.alarm_base);
  const std::string code = fmt::format("{:02}{}00", m.def.channel, alarm_base + number);
  const std::string text = text_of(m);
  return fail(alarm(AlarmId::program_alarm, s.where, std::string_view(code), double(alarm_base + number), std::string_view(text)));
}

/// Executes #3107: shows a question to the operator. The program reads the answer from #3107. An event of the set-up gives the answer;
/// without it the answer is OK or Yes.
Status question(Emitter& m, const Statement& s, int number) {
  if (number < 100 || number > 299) return fail(alarm(AlarmId::message_number, s.where, double(number)));
  auto text = embedded_values(m, text_of(m), s.where);
  if (!text) return fail(text.error());
  macro_b_of(m).answer = number < 200 ? 1 : 2;
  m.emit(Message{std::move(*text), number, true});
  return {};
}

}  // namespace

Status message(Emitter& m, const Statement& s) {
  const auto number = number_of(m, s);
  if (!number) return fail(number.error());
  const Instruction& target = m.block->code[s.target.begin];
  switch (static_cast<int>(target.number)) {
    case 3000: return program_alarm(m, s, *number);
    case 3006:
      m.emit(Message{text_of(m), stop_base + *number, false});
      m.emit(Stop{false, StopReason::message});
      return {};
    case 3106: m.emit(Message{text_of(m), s.value ? *number : -1, false}); return {};
    default: return question(m, s, *number);
  }
}

}  // namespace kadr::macro_b
