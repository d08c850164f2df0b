#pragma once
// Op: one step of an expression. Expressions are compiled to a row of them for a stack.

#include <cstdint>
#include <optional>
#include <string_view>

namespace kadr {

enum class Op : std::uint8_t {
  number,
  variable,
  parameter,  // push; `variable` replaces the top by #top
  add,
  subtract,
  multiply,
  divide,
  modulo,
  power,
  negate,
  logic_and,
  logic_or,
  logic_xor,
  equal,  // comparisons: a vacant value is greater than every number and equal to itself (nct 23.1.6)
  not_equal,
  greater,
  greater_equal,
  less,
  less_equal,
  greater_by_value,  // the same, but a vacant value counts as 0 (spec/fanuc 5.2)
  greater_equal_by_value,
  less_by_value,
  less_equal_by_value,
  abs,
  acos,
  asin,
  atan,
  cos,
  exp,
  fix,
  fup,
  ln,
  round,
  round_increment,  // to the least increment of the unit in force (spec/haas 2.2)
  sin,
  sqrt,
  tan,
  scale,  // divides by `number`: raw digits to the unit of the address
  // custom macros (nct 23.2)
  remainder,
  bit_and,
  bit_or,
  bit_xor,
  nearly_equal,  // within 1e-6 (LinuxCNC 2.9.3)
  nearly_not_equal,
  nearly_greater_equal,  // greater, or within 1e-6
  nearly_less_equal,
  bit_not,
  truncate,        // FIX
  away_from_zero,  // FUP
  square_root,
  sine,
  cosine,
  tangent,
  arc_sine,
  arc_cosine,
  arc_tangent,
  logarithm,
  arc_sine_turn,  // ASIN, 270 … 90 (spec/fanuc 5.3)
  atan_turn,      // ATAN[a]/[b], 0 … 360 (spec/fanuc 5.3)
  to_bcd,         // 25 → 37, the digits as groups of four bits, and back
  from_bcd,
  keep_negate,   // of a word: a vacant value stays vacant
  variable_at,   // push the variable `number`
  element,       // replaces the index on top by the number of that element of symbol `number`
  control_value  // PRM: replaces number, bit, index on top by the value
};

/// The operation of an operator, a function, a relation by its name in control files ("add", "sine").
///   returns  nothing: there is none of that name with so many operands
std::optional<Op> operation_named(std::string_view name, int operands);
/// Names of all with so many operands, for messages.
std::string_view operation_name(std::size_t place, int operands);

constexpr bool is_comparison(Op op) { return op >= Op::equal && op <= Op::less_equal_by_value; }

/// Steps with two operands.
constexpr bool takes_two(Op op) {
  return (op >= Op::add && op <= Op::less_equal_by_value && op != Op::negate) || op == Op::atan || op == Op::atan_turn ||
         (op >= Op::remainder && op <= Op::nearly_less_equal);
}

}  // namespace kadr
