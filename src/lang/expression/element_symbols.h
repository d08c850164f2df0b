#pragma once
// Symbol numbers that the compiler itself passes to Op::element. No control's table of system variables contains these numbers. Each of
// them is a query about the number of a variable; variables with a name also have a number (VariableNames).

namespace kadr {

/// Queries whether a variable exists: EXISTS[#<name>] by its name, EXISTS[#5] by its number (spec/linuxcnc 5). The answer is 1 or 0.
inline constexpr double symbol_name_exists = -1, symbol_number_exists = -3;
/// Returns the variable number itself, unchanged. The control checks that the program has not computed a number that stands for the name of
/// a variable.
///   alarms  the control's own alarm for such a number
inline constexpr double symbol_own_number = -2;

}  // namespace kadr
