// Computes the values of the words of the block being executed, and answers the queries of functions about these words.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "control/interpreter.h"
#include "control/variable_reader.h"
#include "lang/expression/expression.h"

namespace kadr {

/// Computes the value of a word written as an expression. A word with a vacant value counts as not written (nct 23.1.6).
Status Interpreter::evaluate_word(Word& w) {
  const auto result = evaluate(*block, w.expression, VariableReader{*this});
  if (!result) return fail(result.error());
  w.value = *result;
  w.address = w.written;
  if (is_vacant(w.value)) {
    w.address = 0;
    return {};
  }
  if (w.written == indirect_axis) KADR_TRY(find_axis(w));
  if (!def.grammar.word(w.address).code) return {};
  const double written = def.grammar.rounds_codes_of_expressions() && def.address(w.address).whole ? std::round(w.value) : w.value;
  const double nearest = std::round(written * 10);
  const bool is_code = std::fabs(written * 10 - nearest) < tol::whole_number && nearest >= 0 && nearest < ControlDef::most_codes;
  w.code = is_code ? static_cast<std::int32_t>(nearest) : -1;
  return {};
}

Result<double> Emitter::value_of(std::string_view expression) {
  // Controls with this grammar allow sums only in brackets.
  const bool brackets = !def.grammar.sums_without_brackets() && def.grammar.expressions;
  const std::string text = brackets ? fmt::format("[{}]", expression) : std::string(expression);
  Cursor cursor{text};
  Block looked_at;
  looked_at.text = text;
  const auto wrong = [&](std::size_t at) {
    const Span from = {static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(text.size())};
    return fail(alarm(AlarmId::expression_syntax, from, std::string_view(text).substr(at)));
  };
  cursor.skip_blanks();
  if (cursor.at == text.size()) return wrong(0);
  for (int i = 0; i < variables.parameter_count(); ++i)  // A parameter name such as R2 or QN15 is an expression without brackets
    if (!brackets && !def.grammar.sums_without_brackets() && variables.name_of_parameter(i) == text) return variables.parameter(i, {});
  if (!brackets && !def.grammar.sums_without_brackets() && def.grammar.variables == 0) return wrong(0);
  const auto compiled = def.grammar.sums_without_brackets() ? compile_macro_value(cursor, def.grammar, looked_at, MacroValue::sum)
                                                            : compile_value(cursor, def.grammar, looked_at);
  if (!compiled) return fail(compiled.error());
  cursor.skip_blanks();
  if (cursor.at < text.size()) return wrong(cursor.at);
  return kadr::evaluate(looked_at, *compiled, VariableReader{*this});
}

/// Resolves AX[n]=…: finds the axis of the channel whose number across all channels is n (nct 23.2.12).
Status Interpreter::find_axis(Word& w) {
  const auto number = evaluate(*block, w.axis, VariableReader{*this});
  if (!number) return fail(number.error());
  for (std::size_t a = 0; a < axis_count; ++a)
    if (def.axis_numbers[a] == *number) {
      w.address = letters.axis_letter[a];
      return {};
    }
  return fail(alarm(AlarmId::axis_number_wrong, w.where, *number));
}

Status Interpreter::evaluate_words() {
  if (block->code.empty()) return {};
  pass_varies = pass_varies || reads_variables();
  if (!def.behaviour.delayed_assignment) KADR_TRY(assign());
  for (std::uint32_t i = 0; i < block->word_count; ++i)
    if (Word& w = block->words[i]; w.expression) KADR_TRY(evaluate_word(w));
  if (def.grammar.has_vacant_variables() && block->evaluates) note_addresses();
  return {};
}

Status Interpreter::take_words() {
  KADR_TRY(check_ranges());
  return def.behaviour.delayed_assignment && !block->code.empty() ? assign() : Status();
}

/// Rebuilds the set of addresses of the block, after words with a vacant value were removed.
void BlockContext::note_addresses() {
  block->letters = 0;
  for (std::uint32_t i = block->word_count; i-- > 0;) {
    const char address = block->words[i].address;
    if (address == 0) continue;
    block->letters |= letter_bit(address);
    block->at[static_cast<std::size_t>(address - 'A')] = static_cast<std::uint8_t>(i);
  }
}

/// Executes the assignments of the block. All values are computed before the first variable is assigned: `#1=5 X#1` uses the old #1
/// (spec/mach3 1).
Status Interpreter::assign() {
  assigned_.clear();
  for (const Assignment& a : block->assignments) {
    const auto target = evaluate(*block, a.target, VariableReader{*this});
    if (!target) return fail(target.error());
    const auto value = evaluate(*block, a.value, VariableReader{*this});
    if (!value) return fail(value.error());
    assigned_.push_back(*target);
    assigned_.push_back(*value);
  }
  for (std::size_t i = 0; i < block->assignments.size(); ++i) {
    if (def.grammar.parameter_address != 0 || !def.grammar.long_parameters.empty())
      variables.set_parameter(static_cast<int>(assigned_[2 * i]), assigned_[2 * i + 1]);
    else KADR_TRY(dialect->write_variable(*this, assigned_[2 * i], assigned_[2 * i + 1], block->assignments[i].where));
  }
  if (variables.consume_frames_changed()) change_frames();
  return {};
}

/// Executes a block that only assigns variables. The journal records the old values, so nothing else has to be restored after an alarm.
Status Interpreter::assign_alone() {
  pass_varies = true;
  Status done = assign();
  if (done) return done;
  journal.undo();
  (void)variables.consume_frames_changed();
  return done;
}

bool Interpreter::assign_again() {
  journal.begin();
  return assign_alone().has_value();
}

bool sets_variables_only(const Block& block) {
  if (block.assignments.empty() || block.word_count != 0 || block.statement.kind != StatementKind::none) return false;
  if (block.marker != Marker::none || block.skip != 0 || !block.comments.empty()) return false;
  return std::all_of(block.assignments.begin(), block.assignments.end(), [&](const Assignment& a) {
    const Instruction& number = block.code[a.target.begin];
    const bool plain = a.target.end == a.target.begin + 1 && number.op == Op::number;
    return plain && (number.number <= last_common || VariableNames::is_named(number.number));
  });
}

Status BlockContext::check_ranges() const {
  for (std::uint32_t i = 0; i < block->word_count; ++i) {
    const Word& w = block->words[i];
    if (w.address == 0) continue;
    if (!(std::fabs(w.value) <= 1e9)) return fail(alarm(AlarmId::value_out_of_range, w.where, w.address, w.value));
    const AddressRow& row = def.address(w.address);
    if (w.value < 0 && row.least == 0 && def.gives(AlarmId::value_below_zero) && !w.expression)
      return fail(alarm(AlarmId::value_below_zero, w.where, w.address, w.value));
    if (w.value < row.least || w.value > row.most) return fail(alarm(AlarmId::value_out_of_range, w.where, w.address, w.value));
    if (row.whole && w.value != std::floor(w.value)) return fail(alarm(AlarmId::word_not_integer, w.where, w.address, w.value));
  }
  return {};
}

// ---- words

double BlockContext::value(char letter) const {
  const Word* const w = block->find(letter);
  return w == nullptr ? 0.0 : w->value * def.address(letter).scale;
}

bool BlockContext::has_code(std::initializer_list<Function> functions) const {
  if (const ShapeFacts* const facts = shape(); facts != nullptr && facts->shape == block->shape) [[likely]]
    return std::any_of(functions.begin(), functions.end(), [&](Function f) { return facts->functions[static_cast<std::size_t>(f)]; });
  for (std::uint32_t i = 0; i < block->word_count; ++i) {
    const Word& w = block->words[i];
    const std::int32_t row = w.code < 0 || w.address == 0 ? -1 : def.row_of(w.address, w.code);
    if (row >= 0 && std::find(functions.begin(), functions.end(), def.codes[static_cast<std::size_t>(row)].function) != functions.end())
      return true;
  }
  return false;
}

Span BlockContext::where(char letter) const {
  const Word* const w = block->find(letter);
  return w == nullptr ? block->where : w->where;
}

Result<std::uint32_t> BlockContext::whole(char letter, double least, double most) const {
  const double v = value(letter);
  const double nearest = std::round(v);
  if (std::fabs(v - nearest) > tol::whole_number) return fail(alarm(AlarmId::word_not_integer, where(letter), letter, v));
  if (nearest < least || nearest > most) return fail(alarm(AlarmId::value_out_of_range, where(letter), letter, v));
  return static_cast<std::uint32_t>(nearest);
}

}  // namespace kadr
