// The names of operations in control files. Used by config/control/control_loader_expressions.

#include "lang/expression/operation.h"

#include <algorithm>
#include <utility>

namespace kadr {
namespace {

constexpr std::pair<std::string_view, Op> operation_names[] = {
    {"abs", Op::abs},
    {"acos", Op::acos},
    {"asin", Op::asin},
    {"cos", Op::cos},
    {"exp", Op::exp},
    {"fix", Op::fix},
    {"fup", Op::fup},
    {"ln", Op::ln},
    {"round", Op::round},
    {"sin", Op::sin},
    {"sqrt", Op::sqrt},
    {"tan", Op::tan},
    {"bit_not", Op::bit_not},
    {"truncate", Op::truncate},
    {"away_from_zero", Op::away_from_zero},
    {"square_root", Op::square_root},
    {"sine", Op::sine},
    {"cosine", Op::cosine},
    {"tangent", Op::tangent},
    {"arc_sine", Op::arc_sine},
    {"arc_cosine", Op::arc_cosine},
    {"arc_tangent", Op::arc_tangent},
    {"logarithm", Op::logarithm},
    {"add", Op::add},
    {"subtract", Op::subtract},
    {"multiply", Op::multiply},
    {"divide", Op::divide},
    {"modulo", Op::modulo},
    {"power", Op::power},
    {"logic_and", Op::logic_and},
    {"logic_or", Op::logic_or},
    {"logic_xor", Op::logic_xor},
    {"equal", Op::equal},
    {"not_equal", Op::not_equal},
    {"greater", Op::greater},
    {"greater_equal", Op::greater_equal},
    {"less", Op::less},
    {"less_equal", Op::less_equal},
    {"greater_by_value", Op::greater_by_value},
    {"greater_equal_by_value", Op::greater_equal_by_value},
    {"less_by_value", Op::less_by_value},
    {"less_equal_by_value", Op::less_equal_by_value},
    {"to_bcd", Op::to_bcd},
    {"from_bcd", Op::from_bcd},
    {"atan", Op::atan},
    {"atan_turn", Op::atan_turn},
    {"arc_sine_turn", Op::arc_sine_turn},
    {"remainder", Op::remainder},
    {"bit_and", Op::bit_and},
    {"bit_or", Op::bit_or},
    {"bit_xor", Op::bit_xor},
    {"nearly_equal", Op::nearly_equal},
    {"nearly_not_equal", Op::nearly_not_equal},
    {"nearly_greater_equal", Op::nearly_greater_equal},
    {"nearly_less_equal", Op::nearly_less_equal},
};

}  // namespace

std::optional<Op> operation_named(std::string_view name, int operands) {
  for (const auto& [text, op] : operation_names)
    if (text == name && takes_two(op) == (operands == 2)) return op;
  return std::nullopt;
}

std::string_view operation_name(std::size_t place, int operands) {
  for (const auto& [text, op] : operation_names)
    if (takes_two(op) == (operands == 2) && place-- == 0) return text;
  return {};
}

}  // namespace kadr
