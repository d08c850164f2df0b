#pragma once
// Number: the arithmetic of the types INT, REAL, BOOL and CHAR (spec/sinumerik 6.2, 7), without the texts, axes and frames that a Value may
// also hold.

#include <cstdint>
#include <optional>
#include <string_view>

#include "base/alarm.h"
#include "control/sinumerik/value.h"
#include "lang/named/named_block.h"

namespace kadr::sinumerik {

struct Number {
  double value = 0;
  Type type = Type::real;
};

/// Applies an operator. Returns no_alarm, or the alarm that the operands cause; then `to` has not changed.
///   alarms  division_by_zero, not_a_number, operand_type (the operator is not for numbers)
AlarmId apply(NamedOp op, Number a, Number b, Number& to);
Number apply(NamedOp op, Number a);

/// A function of numbers: SIN, POT, BOUND …
struct NumberFunction {
  std::string_view name;
  std::uint16_t operands;
  double (*of)(const double* operands);
  bool (*allows)(double first);  // whether the function has a value at the first operand
  AlarmId fault;                 // the alarm if it has none
};
/// Returns nullptr if no function has this name.
const NumberFunction* number_function(std::string_view name);

/// Returns the number as a variable of the type holds it (spec/sinumerik 6.2): rounded for INT, 0 or 1 for BOOL. Returns nullopt if the
/// type cannot hold it, or is no type of numbers.
std::optional<double> number_as(Type type, double value);

}  // namespace kadr::sinumerik
