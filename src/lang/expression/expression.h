#pragma once
// Expressions of a block. Their text is compiled to instructions once; the instructions are evaluated each time the block is executed. The
// operators and functions are those of spec/mach3 1 (Mach3, RS274/NGC) and spec/nct/23 23.2 (custom macros). Angles are in degrees.

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "base/result.h"
#include "lang/block/block.h"

namespace kadr {

/// A position in the text of an expression; the lexer and the compiler move the same cursor.
struct Cursor {
  std::string_view text;
  std::size_t at = 0;
  char peek() const { return at < text.size() ? text[at] : '\0'; }
  void skip_blanks();
};

/// The value of a variable that was never set, or that an assignment of #0 has emptied (nct 23.1.6). It is a NaN; no other value is a NaN.
inline constexpr double vacant = std::numeric_limits<double>::quiet_NaN();
inline bool is_vacant(double value) { return value != value; }

/// Compiles a value in the form in which it follows an address: number, #n, ##n, #[…], […], function. Appends the instructions to
/// block.code.
///   alarms  expression_syntax, bracket_not_closed, nesting_too_deep, operator_unknown, function_unknown, number_damaged
Result<Expression> compile_value(Cursor& cursor, const Grammar& grammar, Block& block);

/// Compiles the number or name of the variable between `#` and `=` of an assignment. The alarms are those of compile_value.
Result<Expression> compile_target(Cursor& cursor, const Grammar& grammar, Block& block);

/// The form of a value in a custom macro, which decides how much of the text at the cursor belongs to the value.
enum class MacroValue : std::uint8_t {
  operand,   // a value after the address of a word: a number, #n, #[…], #_NAME, […], or a function with its operand
  sum,       // a whole expression
  assigned,  // a whole expression after `#n=`; only in this form is a machine parameter (PRM) allowed (nct 24.2)
};
/// Compiles a value as compile_value() does, but in the language of custom macros (nct 23). Warns of ATAN[a]/[b], which other controls read
/// differently.
///   alarms  expression_syntax (nct 2064), bracket_not_closed, nesting_too_deep, number_damaged, illegal_address
Result<Expression> compile_macro_value(Cursor& cursor, const Grammar& grammar, Block& block, MacroValue extent);
/// Compiles the condition in the brackets of IF[…] and WHILE[…], which is one comparison (nct 23.2.7).
///   alarms  those of compile_macro_value; terminator_wrong
Result<Expression> compile_condition(Cursor& cursor, const Grammar& grammar, Block& block);
/// Compiles the number of a variable, which is written after '#' as digits, […] or _NAME[…].
Result<Expression> compile_macro_target(Cursor& cursor, const Grammar& grammar, Block& block);

/// Returns true if `[#NAME]` is at the cursor (spec/fanuc 5.1).
bool given_name_follows(const Cursor& cursor);

/// An unsigned number with an optional decimal point. read_number() requires that the cursor is at a digit or at the decimal point.
struct Number {
  double value = 0;
  double mantissa = 0;  // the digits without the decimal point, as a whole number
  std::uint8_t whole_digits = 0;
  std::uint8_t fraction_digits = 0;
  bool has_point = false;
};
bool read_number(Cursor& cursor, Number& number);
/// Reads a number with more digits than a double represents exactly.
bool read_long_number(std::string_view digits, Number& number);

/// Executes one step of an expression of RS274/NGC with the operands `a` and `b`.
///   alarms  division_by_zero, not_a_number
Result<double> apply(Op op, double a, double b, Span where);

/// Returns the result of a comparison. Vacant values are ordered as in nct 23.1.6.
inline bool compare(Op op, double a, double b) {
  if (op >= Op::greater_by_value) {
    if (is_vacant(a)) a = 0;
    if (is_vacant(b)) b = 0;
    switch (op) {
      case Op::greater_by_value: return a > b;
      case Op::greater_equal_by_value: return a >= b;
      case Op::less_by_value: return a < b;
      default: return a <= b;
    }
  }
  if (is_vacant(a) || is_vacant(b)) [[unlikely]] {
    const int order = int{is_vacant(a)} - int{is_vacant(b)};  // a vacant value counts as greater than every number
    switch (op) {
      case Op::equal: return order == 0;
      case Op::not_equal: return order != 0;
      case Op::greater: return order > 0;
      case Op::greater_equal: return order >= 0;
      case Op::less: return order < 0;
      default: return order <= 0;
    }
  }
  switch (op) {
    case Op::equal: return a == b;
    case Op::not_equal: return a != b;
    case Op::greater: return a > b;
    case Op::greater_equal: return a >= b;
    case Op::less: return a < b;
    default: return a <= b;
  }
}

/// Evaluates an expression. `variables` is an object with these functions: `variable(number, Span)` and `parameter(index, Span)` return the
/// value or an alarm; `known(number, value)` is a fast access to the value of a variable, and returns false for a variable that it does not
/// cover; `increments()` returns the number of least increments in one unit of the program; `control_value(number, bit, index, Span)` and
/// `element(symbol, index, Span)` return the results of the operations with these names.
template <class Variables>
// NOLINTNEXTLINE(readability-function-size): one switch over all operations
Result<double> evaluate(const Block& block, Expression expression, Variables&& variables) {
  // The stack cannot overflow, because the compiler limits the number of its values.
  std::array<double, limits::expression_depth * 2> stack;
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
      case Op::variable_at: {
        if (variables.known(step.number, stack[top])) [[likely]] {
          ++top;
          break;
        }
        auto value = variables.variable(step.number, step.where);
        if (!value) return value;
        stack[top++] = *value;
        break;
      }
      case Op::round_increment: {
        double parts = 1;
        if constexpr (requires { variables.increments(); }) parts = variables.increments();
        stack[top - 1] = std::round(stack[top - 1] * parts) / parts;
        break;
      }
      case Op::element: {
        auto value = variables.element(step.number, stack[top - 1], step.where);
        if (!value) return value;
        stack[top - 1] = *value;
        break;
      }
      case Op::control_value: {
        auto value = variables.control_value(stack[top - 3], stack[top - 2], stack[top - 1], step.where);
        if (!value) return value;
        top -= 2;
        stack[top - 1] = *value;
        break;
      }
      case Op::scale: stack[top - 1] /= step.number; break;
      case Op::keep_negate: stack[top - 1] = -stack[top - 1]; break;
      case Op::equal:
      case Op::not_equal:
      case Op::greater:
      case Op::greater_equal:
      case Op::less:
      case Op::less_equal:
      case Op::greater_by_value:
      case Op::greater_equal_by_value:
      case Op::less_by_value:
      case Op::less_equal_by_value:
        --top;
        stack[top - 1] = compare(step.op, stack[top - 1], stack[top]) ? 1 : 0;
        break;
      case Op::add:
      case Op::subtract:
      case Op::multiply: {
        --top;
        const double b = is_vacant(stack[top]) ? 0 : stack[top], a = is_vacant(stack[top - 1]) ? 0 : stack[top - 1];
        const double value = step.op == Op::add ? a + b : step.op == Op::subtract ? a - b : a * b;
        if (!std::isfinite(value)) return fail(alarm(AlarmId::not_a_number, step.where));
        stack[top - 1] = value;
        break;
      }
      default: {
        const bool pair = takes_two(step.op);
        double b = pair ? stack[top - 1] : 0;
        double a = pair ? stack[top - 2] : stack[top - 1];
        if (is_vacant(a)) a = 0;  // a vacant operand counts as 0
        if (is_vacant(b)) b = 0;
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
