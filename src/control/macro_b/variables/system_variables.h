#pragma once
// System variables by number (spec/nct/23 23.1.5–23.1.22) and PRM (24.2).

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/span.h"
#include "config/control/control_def.h"

namespace kadr {
class BlockContext;
class Emitter;
struct FinalState;
}  // namespace kadr

namespace kadr::macro_b {

/// A variable number, with its row in the control's table of system variables.
struct FoundVariable {
  const VariableRow* row = nullptr;
  std::uint32_t index = 0;   // index of the variable: the first index of the row plus the offset within the row
  std::uint32_t family = 1;  // value of the digit p in the name of a system variable, such as #_WZPp[n]
  std::uint32_t number = 0;
};

/// Returns the value of variable #number; returns `vacant` if the variable is vacant.
///   alarms  variable_unknown, variable_write_only, not_available
Result<double> read_variable(Emitter& m, double number, Span where);
/// Writes #number.
///   alarms  variable_unknown, variable_read_only (2161), value_limit (2092)
Status write_variable(Emitter& m, double number, double value, Span where);
/// Does the same as write_variable(), but for values of the set-up: the write protection by N1702 and N1703 does not apply, and the set-up
/// can write PLC inputs, which a program only reads.
Status set_start_value(Emitter& m, double number, double value);
/// Returns the variable number of #_NAME[index]. `symbol` is the internal number of NAME. alarms value_out_of_range
Result<double> number_of_element(const BlockContext& m, double symbol, double index, Span where);
/// Returns the variable number of a symbolic name such as "ALM" or "ABSIO[3]"; -1 if the name is unknown.
double number_of_symbol(const BlockContext& m, const std::string& name);
/// Adds to `ending` all variables that are not vacant, and the variables named in `watch` ("#5061", "#_ALM").
void add_variables(Emitter& m, FinalState& ending, const std::vector<std::string>& watch);
/// Reads PRM[number, bit]/[index]; an argument that is an empty variable counts as missing.
Result<double> read_parameter(BlockContext& m, double number, double bit, double index, Span where);

}  // namespace kadr::macro_b
