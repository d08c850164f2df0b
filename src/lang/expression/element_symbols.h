#pragma once
// Symbols of Op::element that are in no table: questions about a number, where names have numbers too (VariableNames).

namespace kadr {

/// EXISTS[#<name>], EXISTS[#5] (spec/linuxcnc 5): 1 or 0.
inline constexpr double symbol_name_exists = -1, symbol_number_exists = -3;
/// The number itself, as the program has it: it is never that of a name.
///   alarms  of the control, where it would be one
inline constexpr double symbol_own_number = -2;

}  // namespace kadr
