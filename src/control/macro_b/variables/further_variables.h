#pragma once
// Variables that some controls with custom macros have in addition to those of the NCT: names given by SETVN, further common variables,
// timers, the tool in the spindle (spec/fanuc 5.1, 5.5, spec/haas 2.4).

#include <optional>

#include "base/result.h"
#include "base/span.h"
#include "config/control/control_def.h"

namespace kadr {
class BlockContext;
struct Statement;
}  // namespace kadr

namespace kadr::macro_b {

/// SETVN n[NAME,NAME]: names the variables #n, #n+1 …
///   alarms  too_many_words: the statement gives more names than the control can store
Status name_variables(BlockContext& m, const Statement& statement);
/// Returns the number of the variable whose name is written as [#NAME]. `number` is the internal number of the name; any other number is
/// returned unchanged.
///   alarms  variable_unknown: no SETVN has given that name
Result<double> number_meant(const BlockContext& m, double number, Span where);

/// The location where the value of a common variable beyond #999 is stored. further_variable() returns this location, or nullopt for any
/// other kind of variable.
struct FurtherVariable {
  bool own = false;  // true: the variable has a value of its own; false: the variable is another name for #number, one of #1 to #999
  std::uint32_t number = 0;
};
std::optional<FurtherVariable> further_variable(const VariableRow& row, std::uint32_t number, std::uint32_t index);
double read_further(const BlockContext& m, FurtherVariable variable);
void write_further(BlockContext& m, FurtherVariable variable, double value);

/// Returns the number of milliseconds in one unit of the timer #3002: 1, or 3,600,000 if the unit is an hour.
double cutting_unit(const VariableRow& row);
double cutting_unit(const ControlDef& def);
/// Returns the value of the timers #3020 to #3025 (spec/haas 2.4), in seconds.
double timer(const BlockContext& m, const VariableRow& row);
/// Returns the operator's switches #3028, #3030 to #3033 (spec/haas 2.4), 1 for on or 0 for off. Block delete and optional stop are as the
/// set-up gives them; all other switches are off during a run.
double operator_switch(const BlockContext& m, const VariableRow& row);

}  // namespace kadr::macro_b
