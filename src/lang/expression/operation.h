#pragma once
// Op: one step of an expression. An expression is compiled to a sequence of steps for a stack machine.

#include <cstdint>
#include <optional>
#include <string_view>

namespace kadr {

enum class Op : std::uint8_t {
  number,
  variable,
  // `variable` replaces a number on top of the stack by the value of the variable with this number; `parameter` pushes the value of a
  // formal parameter.
  parameter,
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
  equal,  // comparisons; a vacant value is greater than every number and equal to itself (nct 23.1.6)
  not_equal,
  greater,
  greater_equal,
  less,
  less_equal,
  greater_by_value,  // comparison like `greater`, but a vacant value counts as 0 (spec/fanuc 5.2)
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
  round_increment,  // rounds to the least increment of the active unit (spec/haas 2.2)
  sin,
  sqrt,
  tan,
  scale,  // divides the top of the stack by Instruction::number, which converts the digits as written to the unit of the address
  // ---- custom macros (nct 23.2)
  remainder,
  bit_and,
  bit_or,
  bit_xor,
  nearly_equal,  // true if the operands differ by less than 1e-6 (LinuxCNC 2.9.3)
  nearly_not_equal,
  nearly_greater_equal,  // true if a is greater than b, or if they differ by less than 1e-6
  nearly_less_equal,
  bit_not,
  truncate,        // FIX: rounds towards 0
  away_from_zero,  // FUP: rounds away from 0
  square_root,
  sine,
  cosine,
  tangent,
  arc_sine,
  arc_cosine,
  arc_tangent,
  logarithm,
  arc_sine_turn,  // ASIN with results from 270 to 90 degrees (spec/fanuc 5.3)
  atan_turn,      // ATAN[a]/[b] with results from 0 to 360 degrees (spec/fanuc 5.3)
  to_bcd,         // converts the decimal number 25 to 37 (0x25): each decimal digit becomes a group of four bits; `from_bcd` converts back
  from_bcd,
  keep_negate,   // negates the value of a word; a vacant value remains vacant
  variable_at,   // pushes the value of the variable with the number Instruction::number
  element,       // replaces the index on top of the stack by the number of the variable with this index; Instruction::number is the symbol
  control_value  // replaces the number, bit and index of a machine parameter (PRM) on top of the stack by the value of the parameter
};

/// Returns the operation of an operator, function or relation by its name in control files ("add", "sine").
///   returns  nullopt if no operation has this name and number of operands
std::optional<Op> operation_named(std::string_view name, int operands);
/// Returns the name of the operation at the index `place` among the operations with this number of operands, for messages; an empty text
/// after the last one.
std::string_view operation_name(std::size_t place, int operands);

constexpr bool is_comparison(Op op) { return op >= Op::equal && op <= Op::less_equal_by_value; }

/// Returns true for steps with two operands.
constexpr bool takes_two(Op op) {
  return (op >= Op::add && op <= Op::less_equal_by_value && op != Op::negate) || op == Op::atan || op == Op::atan_turn ||
         (op >= Op::remainder && op <= Op::nearly_less_equal);
}

}  // namespace kadr
