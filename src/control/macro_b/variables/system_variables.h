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

/// A variable number resolved in the control's table.
struct FoundVariable {
  const VariableRow* row = nullptr;
  std::uint32_t index = 0;   // counted from the row's first index
  std::uint32_t family = 1;  // p of #_WZPp[n]
  std::uint32_t number = 0;
};

/// Reads #number; vacant if it is empty.
///   alarms  variable_unknown, variable_write_only, not_available
Result<double> read_variable(Emitter& m, double number, Span where);
/// Writes #number.
///   alarms  variable_unknown, variable_read_only (2161), value_limit (2092)
Status write_variable(Emitter& m, double number, double value, Span where);
/// Like write_variable(), for the set-up: N1702, N1703 do not protect variables from it, and PLC inputs can be given.
Status set_start_value(Emitter& m, double number, double value);
/// Returns the number of #_NAME[index]. alarms value_out_of_range
Result<double> number_of_element(const BlockContext& m, double symbol, double index, Span where);
/// Returns the number of "ALM" or "ABSIO[3]"; -1 if unknown.
double number_of_symbol(const BlockContext& m, const std::string& name);
/// Adds the variables that hold a value, and those in `watch` ("#5061", "#_ALM").
void add_variables(Emitter& m, Ending& ending, const std::vector<std::string>& watch);
/// Reads PRM[number, bit]/[index]; a vacant argument counts as missing.
Result<double> read_parameter(BlockContext& m, double number, double bit, double index, Span where);

}  // namespace kadr::macro_b
