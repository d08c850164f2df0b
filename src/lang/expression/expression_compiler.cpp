// Compiles expressions to instructions. Operators, functions and relations are rows of the control's file (ExpressionRules). All other
// rules depend on Grammar::custom_macros: true for custom macros (spec/nct/23, with their grammar at the end), false for RS274/NGC
// (spec/mach3 1). Used by lexer, word_reader and statement_reader; tested by tests/lang/expression_test.cpp, macro_test.cpp,
// expression_rules_test.cpp.

#include <algorithm>

#include "base/ascii.h"
#include "lang/expression/element_symbols.h"
#include "lang/expression/expression.h"
#include "lang/expression/step_writer.h"
#include "lang/text/encoding.h"

namespace kadr {
namespace {

class Compiler : public StepWriter {
 public:
  Compiler(Cursor& cursor, const Grammar& grammar, Block& block, bool reads_parameters = false)
      : StepWriter(cursor, grammar, block), reads_parameters_(reads_parameters) {}

  /// Compiles by precedence climbing: a value, then the operators whose priority is at least `least_binding`, each with its right operand.
  Status sum(int least_binding) {
    KADR_TRY(factor());
    for (;;) {
      cursor_.skip_blanks();
      const std::size_t begin = cursor_.at;
      std::size_t length = 0;
      const ExpressionRow* const found = row_here(grammar_.expression.operators, length);
      if (found == nullptr) return grammar_.sums_without_brackets() ? Status() : end_of_expression(begin);
      if (found->binding == 0) return fail(alarm(AlarmId::operator_unknown, span(begin, begin + length), std::string_view(found->text)));
      if (found->binding < least_binding) return {};
      const bool left_is_condition = is_condition_;
      cursor_.at += length;
      KADR_TRY(enter(begin));
      KADR_TRY(sum(found->binding + 1));
      --depth_;
      KADR_TRY(joined(found->op, begin, left_is_condition));
      KADR_TRY(step(found->op, 0, begin, -1));
    }
  }

  /// Compiles an optional sign, then a value.
  Status factor() {
    cursor_.skip_blanks();
    const std::size_t begin = cursor_.at;
    const char c = cursor_.peek();
    if (c != '-' && c != '+') return value();
    ++cursor_.at;
    KADR_TRY(enter(begin));
    KADR_TRY(of_numbers([this] { return factor(); }));
    --depth_;
    return c == '-' ? step(Op::negate, 0, begin, 0) : Status();
  }

  /// Compiles a number, #value, [expression], a function with its operand, AXNUM[…] or PRM[…].
  Status value() {
    cursor_.skip_blanks();
    return cursor_.peek() == '[' ? bracket() : of_numbers([this] { return number_here(); });
  }

  /// Adds a step that checks that the variable number, computed by the steps from `first` on, is not that of a named variable.
  Status own_number(std::size_t begin, std::size_t first) {
    if (grammar_.named_variables == nullptr && grammar_.given_names == nullptr) return {};
    const bool is_small =
        block_.code.size() == first + 1 && block_.code[first].op == Op::number && !VariableNames::is_named(block_.code[first].number);
    return is_small ? Status() : step(Op::element, symbol_own_number, begin, 0);
  }

  /// Compiles the part after '#': digits, […], _NAME[…] (nct 23.1.1). `##n` is an error.
  Status reference(bool& constant_number, double& number) {
    cursor_.skip_blanks();
    const std::size_t begin = cursor_.at, first = block_.code.size();
    const char c = cursor_.peek();
    constant_number = false;
    if (is_digit(c)) {
      Number read;
      if (!read_number(cursor_, read) || read.has_point) return fail(alarm(AlarmId::number_damaged, span(begin, cursor_.at), '#'));
      constant_number = grammar_.given_names == nullptr || !VariableNames::is_named(read.value);
      number = read.value;
      if (constant_number) return {};
      KADR_TRY(step(Op::number, number, begin, 1));
      return own_number(begin, first);
    }
    if (c == '[' && grammar_.given_names != nullptr && given_name_follows(cursor_)) {
      constant_number = true;
      return given_name(number);
    }
    if (c == '_') return symbol(constant_number, number);
    if (c != '[') return wrong(begin);
    KADR_TRY(bracket());
    return own_number(begin, first);
  }

  Status variable(std::size_t begin) {
    bool constant_number = false;
    double number = 0;
    KADR_TRY(enter(begin));
    KADR_TRY(reference(constant_number, number));
    --depth_;
    return constant_number ? step(Op::variable_at, number, begin, 1) : step(Op::variable, 0, begin, 0);
  }

  /// Reports `WHILE #1=5`: an assignment is not allowed in place of a condition (nct 23.2.11).
  Status no_assignment() {
    const std::size_t begin = cursor_.at++;
    KADR_TRY(variable(begin));
    cursor_.skip_blanks();
    const std::size_t at = cursor_.at;
    if (cursor_.peek() == '=') return fail(alarm(AlarmId::terminator_wrong, span(at, at + 1), '='));
    return wrong(begin);
  }

  Status relation() {
    in_condition_ = true;
    KADR_TRY(sum(1));
    cursor_.skip_blanks();
    const std::size_t begin = cursor_.at;
    std::size_t length = 0;
    const ExpressionRow* const found = row_here(grammar_.expression.relations, length);
    if (found == nullptr) {
      const bool holds_one = grammar_.conditions_are_values || is_condition_;
      // The expression read before is a comparison that is written with an operator, so the condition is complete.
      if (cursor_.peek() == ']' && holds_one && grammar_.expression.operators.compare()) return {};
      if (cursor_.peek() == '=') return fail(alarm(AlarmId::terminator_wrong, span(begin, begin + 1), '='));
      return wrong(begin);
    }
    cursor_.at += length;
    KADR_TRY(sum(1));
    return step(found->op, 0, begin, -1);
  }

  /// Compiles #<name> (spec/linuxcnc 4.2). `use`: Op::variable_at pushes the variable's value, Op::number pushes the variable's number.
  Status named(std::size_t begin, Op use) {
    const std::size_t open = cursor_.at;
    const std::size_t close = cursor_.text.find('>', open);
    if (close == std::string_view::npos) {
      cursor_.at = cursor_.text.size();
      return fail(alarm(AlarmId::variable_name_open, span(begin, cursor_.at)));
    }
    cursor_.at = close + 1;
    const auto number = grammar_.named_variables->number_of(cursor_.text.substr(open + 1, close - open - 1));
    if (!number) return fail(alarm(AlarmId::too_many_words, span(begin, cursor_.at), double{VariableNames::most}));
    return step(use, *number, begin, 1);
  }

 private:
  Status number_here() {
    const std::size_t begin = cursor_.at;
    const char c = cursor_.peek();
    if (is_digit(c) || c == '.') return number();
    if (c == '#') {
      ++cursor_.at;
      if (grammar_.named_variables != nullptr && named_here()) return named(begin, Op::variable_at);
      return grammar_.custom_macros ? variable(begin) : variable_of_value(begin);
    }
    if (is_letter(c)) return word();
    return wrong(begin);
  }

  Status number() {
    const std::size_t begin = cursor_.at;
    Number read;
    if (!read_number(cursor_, read)) return fail(alarm(AlarmId::number_damaged, span(begin, cursor_.at)));
    return step(Op::number, read.value, begin, 1);
  }

  Status bracket() {
    if (grammar_.given_names != nullptr && given_name_follows(cursor_)) {
      const std::size_t at = cursor_.at;
      double number = 0;
      KADR_TRY(given_name(number));
      is_condition_ = false;
      return step(Op::variable_at, number, at, 1);
    }
    const std::size_t begin = cursor_.at++;
    KADR_TRY(enter(begin));
    KADR_TRY(sum(1));
    --depth_;
    return close(begin);
  }

  Status word() {
    const std::size_t begin = cursor_.at;
    if (grammar_.named_variables != nullptr && starts_with("EXISTS", begin)) return exists(begin);
    std::size_t length = 0;
    if (const ExpressionRow* const found = row_here(grammar_.expression.functions, length); found != nullptr) {
      cursor_.at += length;
      cursor_.skip_blanks();
      if (found->operand == Operand::value) return function_of_value(*found, begin);
      if (cursor_.peek() == '[') return function_of_bracket(*found, begin);
    }
    if (grammar_.custom_macros && starts_with("AXNUM", begin)) return axis_number(begin);
    if (grammar_.custom_macros && starts_with("PRM", begin)) return control_value(begin);
    std::size_t end = begin;
    while (end < cursor_.text.size() && is_letter(cursor_.text[end])) ++end;
    const AlarmId id = end - begin > 1 || !grammar_.custom_macros ? AlarmId::function_unknown : AlarmId::expression_syntax;
    return fail(alarm(id, span(begin, end), cursor_.text.substr(begin, end - begin)));
  }

  /// Compiles EXISTS[#<name>], EXISTS[#5] (spec/linuxcnc 5).
  Status exists(std::size_t begin) {
    cursor_.at = begin + 6;
    cursor_.skip_blanks();
    if (cursor_.peek() != '[') return fail(alarm(AlarmId::function_bracket, span(begin, cursor_.at + 1)));
    ++cursor_.at;
    cursor_.skip_blanks();
    if (cursor_.peek() != '#') return fail(alarm(AlarmId::exists_parameter, span(begin, cursor_.at + 1)));
    ++cursor_.at;
    const bool is_name = named_here();
    if (is_name) {
      KADR_TRY(named(begin, Op::number));
    } else {
      KADR_TRY(enter(begin));
      KADR_TRY(factor());
      --depth_;
    }
    cursor_.skip_blanks();
    if (cursor_.peek() != ']') return fail(alarm(AlarmId::exists_bracket, span(begin, cursor_.at + 1)));
    ++cursor_.at;
    // The control determines during execution whether the variable exists.
    return step(Op::element, is_name ? symbol_name_exists : symbol_number_exists, begin, 0);
  }

  /// Compiles a function whose operand is only the next value, with the signs of this value (nct 23.2.4).
  Status function_of_value(const ExpressionRow& row, std::size_t begin) {
    const std::size_t operand = cursor_.at;
    KADR_TRY(enter(begin));
    KADR_TRY(factor());
    --depth_;
    if (row.of_two != Op::number && divides_bracket(operand)) {
      KADR_TRY(bracket());
      return step(row.of_two, 0, begin, -1);
    }
    if (row.op == Op::arc_tangent) warn_of_quotient(begin, operand);
    return step(row.op, 0, begin, 0);
  }

  Status function_of_bracket(const ExpressionRow& row, std::size_t begin) {
    KADR_TRY(bracket());
    if (row.operand == Operand::bracket) return step(row.op, 0, begin, 0);
    const auto other_missing = [&] {  // the alarm for ATAN[y]/[x] without the second bracket
      return fail(alarm(AlarmId::expression_syntax, span(begin, cursor_.at), std::string_view(row.text + "[ ]/[ ]")));
    };
    cursor_.skip_blanks();
    if (cursor_.peek() != '/') return other_missing();
    ++cursor_.at;
    cursor_.skip_blanks();
    if (cursor_.peek() != '[') return other_missing();
    KADR_TRY(bracket());
    return step(row.op, 0, begin, -1);
  }

  /// Warns of ATAN[a]/[b]. A Fanuc computes one function of both numbers; this control divides ATAN[a] by b (nct 23.2.6).
  void warn_of_quotient(std::size_t begin, std::size_t operand) {
    if (cursor_.text[operand] != '[') return;
    Cursor ahead = cursor_;
    ahead.skip_blanks();
    if (ahead.peek() != '/') return;
    ++ahead.at;
    ahead.skip_blanks();
    if (ahead.peek() == '[') block_.warnings.push_back(warning(AlarmId::arctangent_divides, span(begin, ahead.at)));
  }

  /// Compiles a machine parameter: PRM[n], PRM[n,bit], each also with /[index] (nct 24.2). An omitted bit or index becomes a vacant value.
  Status control_value(std::size_t begin) {
    cursor_.at = begin + 3;
    // A machine parameter (PRM) is allowed only in an assignment (nct 24.2).
    if (!reads_parameters_) return fail(alarm(AlarmId::illegal_address, span(begin, cursor_.at), "PRM"));
    cursor_.skip_blanks();
    if (cursor_.peek() != '[') return wrong(cursor_.at);
    const std::size_t open = cursor_.at++;
    KADR_TRY(enter(begin));
    KADR_TRY(sum(1));
    cursor_.skip_blanks();
    if (cursor_.peek() == ',') {
      ++cursor_.at;
      KADR_TRY(sum(1));
    } else {
      KADR_TRY(step(Op::number, vacant, begin, 1));
    }
    KADR_TRY(close(open));
    Cursor ahead = cursor_;
    ahead.skip_blanks();
    const bool divides = ahead.peek() == '/';
    ++ahead.at;
    ahead.skip_blanks();
    if (divides && ahead.peek() == '[') {
      cursor_.at = ahead.at;
      KADR_TRY(bracket());
    } else {
      KADR_TRY(step(Op::number, vacant, begin, 1));
    }
    --depth_;
    return step(Op::control_value, 0, begin, -2);
  }

  /// Compiles a named system variable: _ABSIO[3], _ALM (nct 23.1.1).
  Status symbol(bool& constant_number, double& number) {
    const std::size_t begin = cursor_.at++;
    std::string name;
    while (is_letter(cursor_.peek()) || is_digit(cursor_.peek()) || cursor_.peek() == '_') name += to_upper(cursor_.text[cursor_.at++]);
    const auto found = std::lower_bound(grammar_.symbols.begin(), grammar_.symbols.end(), name,
                                        [](const VariableName& row, const std::string& text) { return row.text < text; });
    if (found == grammar_.symbols.end() || found->text != name)
      return fail(alarm(AlarmId::illegal_address, span(begin - 1, cursor_.at), cursor_.text.substr(begin - 1, cursor_.at - begin + 1)));
    cursor_.skip_blanks();
    if (!found->indexed) {
      constant_number = true;
      number = found->number;
      return {};
    }
    if (cursor_.peek() != '[') return wrong(cursor_.at);
    KADR_TRY(bracket());
    return step(Op::element, static_cast<double>(found - grammar_.symbols.begin()), begin - 1, 0);
  }

  /// Checks, for RS274/NGC, that an operator, ] or the end of the text follows an operand.
  Status end_of_expression(std::size_t at) const {
    const char c = cursor_.peek();
    if (c == ']' || c == '\0') return {};
    // A value follows another value, so the operator between them is missing.
    const bool is_value = c == '#' || c == '[' || c == '.' || is_digit(c);
    return fail(alarm(is_value ? AlarmId::expression_syntax : AlarmId::operator_unknown, span(at, at + 1), character_at(at)));
  }

  /// Compiles, for RS274/NGC, the value after '#'. Any value is allowed, also #-1 and ##1.
  Status variable_of_value(std::size_t begin) {
    const std::size_t first = block_.code.size();
    KADR_TRY(enter(begin));
    KADR_TRY(factor());
    --depth_;
    KADR_TRY(own_number(begin, first));
    return step(Op::variable, 0, begin, 0);
  }

  bool reads_parameters_;
};

template <class Compile>
Result<Expression> compiled(Block& block, Compile compile) {
  Expression expression;
  expression.begin = static_cast<std::uint16_t>(block.code.size());
  KADR_TRY(compile());
  expression.end = static_cast<std::uint16_t>(block.code.size());
  return expression;
}

}  // namespace

Result<Expression> compile_value(Cursor& cursor, const Grammar& grammar, Block& block) {
  Compiler compiler(cursor, grammar, block);
  return compiled(block, [&] { return compiler.factor(); });
}

Result<Expression> compile_target(Cursor& cursor, const Grammar& grammar, Block& block) {
  Compiler compiler(cursor, grammar, block);
  return compiled(block, [&]() -> Status {
    const std::size_t begin = cursor.at, first = block.code.size();
    if (grammar.named_variables != nullptr && compiler.named_here()) return compiler.named(begin, Op::number);
    KADR_TRY(compiler.factor());
    return compiler.own_number(begin, first);
  });
}

Result<Expression> compile_macro_value(Cursor& cursor, const Grammar& grammar, Block& block, MacroValue extent) {
  Compiler compiler(cursor, grammar, block, extent == MacroValue::assigned);
  return compiled(block, [&] { return extent == MacroValue::operand ? compiler.value() : compiler.sum(1); });
}

Result<Expression> compile_condition(Cursor& cursor, const Grammar& grammar, Block& block) {
  Compiler compiler(cursor, grammar, block);
  return compiled(block, [&]() -> Status {
    cursor.skip_blanks();
    const std::size_t open = cursor.at;
    if (cursor.peek() == '#') KADR_TRY(compiler.no_assignment());
    if (cursor.peek() != '[') return compiler.wrong(open);
    ++cursor.at;
    KADR_TRY(compiler.relation());
    cursor.skip_blanks();
    const Span at{static_cast<std::uint32_t>(open), static_cast<std::uint32_t>(open + 1)};
    if (cursor.peek() != ']' && compiler.is_open(open)) return fail(alarm(AlarmId::bracket_not_closed, at));
    if (cursor.peek() != ']') return compiler.wrong(cursor.at);
    ++cursor.at;
    return {};
  });
}

Result<Expression> compile_macro_target(Cursor& cursor, const Grammar& grammar, Block& block) {
  Compiler compiler(cursor, grammar, block);
  return compiled(block, [&]() -> Status {
    const std::size_t begin = cursor.at;
    bool constant_number = false;
    double number = 0;
    KADR_TRY(compiler.reference(constant_number, number));
    return constant_number ? compiler.step(Op::number, number, begin, 1) : Status();
  });
}

}  // namespace kadr
