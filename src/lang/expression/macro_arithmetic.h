#pragma once
// Executes the operations of custom macros that differ from those of RS274/NGC (spec/nct/23 23.2.2–23.2.5).

#include "base/result.h"
#include "lang/block/block.h"

namespace kadr {

/// Executes one step of an expression of custom macros with the operands `a` and `b`.
///   alarms  division_by_zero, bits_out_of_range, root_of_negative, tangent_of_right_angle, argument_above_one, argument_not_positive,
///     not_a_number
Result<double> apply_macro(Op op, double a, double b, Span where);

/// Returns std::fmod(a, b) for b other than 0. Faster than std::fmod if both are whole numbers.
double remainder_of(double a, double b);

}  // namespace kadr
