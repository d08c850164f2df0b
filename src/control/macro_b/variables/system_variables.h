#pragma once
// System variables by number (spec/nct/23 23.1.5–23.1.22) and PRM (24.2).

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/span.h"
#include "config/control_def.h"

namespace kadr {
class BlockContext;
class Emitter;
struct Ending;
}  // namespace kadr

namespace kadr::macro_b {

/// A number found in the control's table.
struct FoundVariable {
  const VariableRow* row = nullptr;
  std::uint32_t index = 0;   // from the row's first index on
  std::uint32_t family = 1;  // p of #_WZPp[n]
  std::uint32_t number = 0;
};

/// Value of #number, vacant where it is empty.
///   alarms  illegal_address… variable_unknown, variable_write_only
Result<double> read_variable(Emitter& m, double number, Span where);
/// Writes #number.
///   alarms  variable_unknown, variable_read_only (2161), value_limit (2092)
Status write_variable(Emitter& m, double number, double value, Span where);
/// The same for the set-up: N1702, N1703 protect nothing from it, and inputs of the PLC can be given.
Status set_start_value(Emitter& m, double number, double value);
/// #_NAME[index] → number. alarms value_out_of_range
Result<double> number_of_element(const BlockContext& m, double symbol, double index, Span where);
/// Number of "ALM" or "ABSIO[3]"; -1: unknown.
double number_of_symbol(const BlockContext& m, const std::string& name);
/// Variables that hold something, and those that are asked for ("#5061", "#_ALM").
void add_variables(Emitter& m, Ending& ending, const std::vector<std::string>& watch);
/// PRM[number, bit]/[index]; vacant: left out.
Result<double> read_parameter(BlockContext& m, double number, double bit, double index, Span where);

}  // namespace kadr::macro_b
