#pragma once
// Numbers of symbols for Op::element that no control's table contains: queries about a variable number, where named variables have
// numbers too (VariableNames).

namespace kadr {

/// EXISTS[#<name>], EXISTS[#5] (spec/linuxcnc 5): 1 or 0.
inline constexpr double symbol_name_exists = -1, symbol_number_exists = -3;
/// Passes the number on as the program has it, after the check that it is not the number of a name.
///   alarms  an alarm of the control if it is
inline constexpr double symbol_own_number = -2;

}  // namespace kadr
