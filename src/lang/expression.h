#pragma once
// Expressions of a block: text → instructions (once), instructions → value (each time).
// Operators and functions: Mach3 / RS274-NGC, spec/mach3 1. Angles in degrees.

#include <array>
#include <string>
#include <string_view>

#include "base/result.h"
#include "lang/block.h"

namespace kadr {

/// Where an expression's text is read from; shared with the lexer.
struct Cursor {
  std::string_view text;
  std::size_t at = 0;
  char peek() const { return at < text.size() ? text[at] : '\0'; }
  void skip_blanks();
};

/// Compiles a value as it follows an address: number, #n, ##n, #[…], […], function; appends to block.code.
///   alarms  expression_syntax, bracket_not_closed, nesting_too_deep, operator_unknown, function_unknown, number_damaged
Result<Expression> compile_value(Cursor& cursor, const Grammar& grammar, Block& block);

/// Reads an unsigned number with an optional point; the cursor must stand on a digit or a point.
struct Number {
  double value = 0;
  double mantissa = 0;  // the digits without their point, as a whole number
  std::uint8_t whole_digits = 0;
  std::uint8_t fraction_digits = 0;
  bool has_point = false;
};
bool read_number(Cursor& cursor, Number& number);
/// The same for digits that a double does not hold exactly.
bool read_long_number(std::string_view digits, Number& number);

/// Value of one step on the operands `a`, `b`.
///   alarms  division_by_zero, not_a_number
Result<double> apply(Op op, double a, double b, Span where);

/// Runs the instructions. `variable(double number, Span)` and `parameter(int)` give Result<double>.
template <class Variables>
Result<double> evaluate(const Block& block, Expression expression, Variables&& variables) {
  std::array<double, limits::expression_depth * 2> stack;  // the compiler bounds the depth
  std::size_t top = 0;
  for (std::size_t i = expression.begin; i < expression.end; ++i) {
    const Instruction& step = block.code[i];
    switch (step.op) {
      case Op::number: stack[top++] = step.number; break;
      case Op::parameter: {
        auto value = variables.parameter(static_cast<int>(step.number), step.where);
        if (!value) return value;
        stack[top++] = *value;
        break;
      }
      case Op::variable: {
        auto value = variables.variable(stack[top - 1], step.where);
        if (!value) return value;
        stack[top - 1] = *value;
        break;
      }
      case Op::scale: stack[top - 1] /= step.number; break;
      default: {
        const bool pair = (step.op >= Op::add && step.op <= Op::less_equal && step.op != Op::negate) || step.op == Op::atan;
        const double b = pair ? stack[top - 1] : 0;
        const double a = pair ? stack[top - 2] : stack[top - 1];
        auto value = apply(step.op, a, b, step.where);
        if (!value) return value;
        if (pair) --top;
        stack[top - 1] = *value;
      }
    }
  }
  return stack[0];
}

}  // namespace kadr
