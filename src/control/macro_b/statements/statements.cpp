// Executes assignments and the statements IF, GOTO, WHILE … DO … END (spec/nct/23 23.2).

#include <cmath>

#include "control/macro_b/dialect/blocks.h"
#include "control/macro_b/macro_b.h"
#include "control/macro_b/output/output.h"
#include "control/macro_b/statements/messages.h"
#include "control/macro_b/variables/further_variables.h"
#include "control/macro_b/variables/system_variables.h"
#include "control/variable_reader.h"
#include "lang/expression/expression.h"

namespace kadr::macro_b {
namespace {

Result<double> value_of(Emitter& m, Expression expression) { return evaluate(*m.block, expression, VariableReader{m}); }

/// Returns the number of the variable that an assignment writes. In most programs the number is a constant, which needs no evaluation.
Result<double> target_of(Emitter& m, const Statement& s) {
  const Instruction& first = m.block->code[s.target.begin];
  if (s.target.end - s.target.begin == 1 && first.op == Op::number) return first.number;
  return value_of(m, s.target);
}

/// Saves the old value of the variable, so that an alarm in the words after the assignment restores it.
void keep_target(BlockContext& m, double target) {
  MacroB& macros = macro_b_of(m);
  const auto n = static_cast<int>(target);
  if (n >= first_common && n <= last_common) macros.variables.keep_common(m.journal, n);
  else if (n >= 1 && n <= static_cast<int>(max_locals)) m.journal.keep(macros.variables.locals()[static_cast<std::size_t>(n)]);
}

Status assign(Emitter& m, const Statement& s) {
  const auto target = target_of(m, s);
  if (!target) return fail(target.error());
  const auto value = value_of(m, s.value);
  if (!value) return fail(value.error());
  const double most = m.def.behaviour.result_most;
  if (most > 0 && std::fabs(*value) > most) return fail(alarm(AlarmId::result_too_large, s.where, *value));
  if (s.words_follow) keep_target(m, *target);
  return write_variable(m, *target, *value, s.where);
}

Status faulty(const Loop& loop, Span where) { return fail(alarm(loop.fault, where, double(loop.number))); }

/// Jumps to `target`, except for a jump back in a loop that would never end.
Status jump_to(Interpreter& m, Position target, Span where) {
  if (target.offset <= m.block->position.offset) {
    switch (macro_b_of(m).endless.look(m, target, m.program().reader(), m.program().blocks())) {
      case Endless::Verdict::go: break;
      case Endless::Verdict::leave: return {};
      case Endless::Verdict::endless: return fail(alarm(AlarmId::endless_program, where, double(m.program().repeated())));
    }
  }
  m.flow.jump(target);
  return {};
}

/// Executes WHILE[…] DOm or DOm: continues with the first block of the loop if the condition holds, otherwise after the END of the loop
/// (23.2.11).
Status loop(Interpreter& m, const Statement& s, bool holds) {
  ProgramFile& file = m.flow.program_file();
  const Loop* const found = file.loop_from(m.block->position);
  if (found == nullptr) return {};  // Kadr records a limited number of loops in a file, so a loop that is not recorded raises no alarm.
  if (found->fault != no_alarm) return faulty(*found, s.where);
  if (!holds) m.flow.jump(found->after_end);
  return {};
}

/// Executes ENDm: jumps back to the DOm of the loop. The DOm is searched in the program text, because a GOTO may have entered the loop
/// without executing the DOm.
Status loop_end(Interpreter& m, const Statement& s) {
  const Loop* const found = m.flow.program_file().loop_to(m.block->position);
  if (found == nullptr) return fail(alarm(AlarmId::end_without_do, s.where, double(s.loop)));
  if (found->damaged) return {};
  if (found->fault != no_alarm) return faulty(*found, s.where);
  return jump_to(m, found->begin, s.where);
}

/// Returns true if all conditions of an IF or WHILE are true.
Result<bool> holds(Emitter& m, const Statement& s) {
  for (std::uint8_t i = 0; i < s.condition_count; ++i) {
    const auto value = value_of(m, s.conditions[i]);
    if (!value) return fail(value.error());
    if (*value == 0) return false;
  }
  return true;
}

Status jump(Interpreter& m, const Statement& s) {
  const auto number = value_of(m, s.value);
  if (!number) return fail(number.error());
  return go_to_block(m, *number, s.where);
}

Status execute(Interpreter& m, const Statement& s, bool holds) {
  if (s.kind == StatementKind::loop) return loop(m, s, holds);
  if (!holds) return {};
  switch (s.kind) {
    case StatementKind::assign: return assign(m, s);
    case StatementKind::message: return message(m, s);
    case StatementKind::go_to: return jump(m, s);
    case StatementKind::loop_end: return loop_end(m, s);
    case StatementKind::names: return name_variables(m, s);
    default: return output(m, s);
  }
}

}  // namespace

Result<Position> block_numbered(Interpreter& m, double number, Span where) {
  if (is_vacant(number)) return fail(alarm(AlarmId::block_number_vacant, where));
  const double nearest = std::round(number);
  const auto missing = [&] { return fail(alarm(AlarmId::block_not_found, where, number)); };
  if (!(nearest >= 0 && nearest <= 99'999'999)) return missing();
  const auto found = m.flow.program_file().find_number(static_cast<std::uint32_t>(nearest), m.program().position());
  if (!found) return missing();
  return *found;
}

Status go_to_block(Interpreter& m, double number, Span where) {
  const auto found = block_numbered(m, number, where);
  if (!found) return fail(found.error());
  return jump_to(m, *found, where);
}

Status go_to_block_again(Interpreter& m, double number, Span where) {
  const auto found = block_numbered(m, number, where);
  if (!found) return fail(found.error());
  if (found->offset <= m.block->position.offset) return m.begin_again(where, *found);
  m.flow.jump(*found);
  return {};
}

Result<bool> run_statement(Interpreter& m) {
  const Statement& s = m.block->statement;
  const auto condition = holds(m, s);
  if (!condition) return fail(condition.error());
  if (s.kind == StatementKind::words) return !*condition;
  KADR_TRY(execute(m, s, *condition));
  return !(s.words_follow && *condition);
}

}  // namespace kadr::macro_b
