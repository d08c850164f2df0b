#pragma once
// Variables that controls with custom macros have beside those of the NCT: names of SETVN, further common variables, timers, the tool in
// the spindle (spec/fanuc 5.1, 5.5, spec/haas 2.4).

#include <optional>

#include "base/result.h"
#include "base/span.h"
#include "config/control_def.h"

namespace kadr {
class BlockContext;
struct Statement;
}  // namespace kadr

namespace kadr::macro_b {

/// SETVN n[NAME,NAME]: names of #n, #n+1 …
///   alarms  variable_unknown
Status name_variables(BlockContext& m, const Statement& statement);
/// The number of a variable that the program writes as [#NAME]; others as they are.
///   alarms  variable_unknown: no SETVN has given that name
Result<double> number_meant(const BlockContext& m, double number, Span where);

/// Common variables beyond #999: where they stand. Nothing: it is another kind of variable.
struct FurtherVariable {
  bool own = false;  // beyond all others; else the same cell as `number`
  std::uint32_t number = 0;
};
std::optional<FurtherVariable> further_variable(const VariableRow& row, std::uint32_t number, std::uint32_t index);
double read_further(const BlockContext& m, FurtherVariable variable);
void write_further(BlockContext& m, FurtherVariable variable, double value);

/// Milliseconds in one unit of #3002: 1, or those of an hour.
double cutting_unit(const VariableRow& row);
double cutting_unit(const ControlDef& def);
/// #3020 to #3025 (spec/haas 2.4), in seconds.
double timer(const BlockContext& m, const VariableRow& row);
/// #3028, #3030 to #3033 (spec/haas 2.4): block delete and optional stop as the set-up has them, 1 or 0; the others are 0 in a run.
double operator_switch(const BlockContext& m, const VariableRow& row);

}  // namespace kadr::macro_b
