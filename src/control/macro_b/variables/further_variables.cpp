// Names given by SETVN, further common variables, timers (spec/fanuc 5.1, 5.5, spec/haas 2.4). Used by
// control/macro_b/variables/system_variables, control/macro_b/statements/statements.

#include "control/macro_b/variables/further_variables.h"

#include <algorithm>
#include <cmath>

#include "control/block_context.h"
#include "control/macro_b/macro_b.h"

namespace kadr::macro_b {
namespace {

constexpr double ms_of_hour = 3'600'000;
constexpr double ms_of_second = 1000;

/// The quantity that a timer variable measures; the values are those of the key `arg` in the control's file.
enum class TimerOf { power_on = 20, cycle_start = 21, feed = 22, this_part = 23 };

/// The values of the key `arg` for the operator's switches that a set-up can set. The other switches (pallet, single block, dry run) are
/// always off.
constexpr int block_delete = 32, stop_at_m1 = 33;

}  // namespace

Status name_variables(BlockContext& m, const Statement& statement) {
  std::string_view names = m.block->text_of(statement.text);
  double number = m.block->code[statement.value.begin].number;
  for (bool more = true; more; ++number) {
    const std::size_t comma = names.find(',');
    more = comma != std::string_view::npos;
    const auto named = m.def.grammar.given_names->number_of(names.substr(0, comma));
    if (!named) return fail(alarm(AlarmId::too_many_words, statement.where, double{VariableNames::most}));
    macro_b_of(m).variable_names[*named] = number;
    if (more) names.remove_prefix(comma + 1);
  }
  return {};
}

Result<double> number_meant(const BlockContext& m, double number, Span where) {
  if (!VariableNames::is_named(number) || m.def.grammar.given_names == nullptr) return number;
  const auto& names = macro_b_of(m).variable_names;
  if (const auto found = names.find(number); found != names.end()) return found->second;
  return fail(alarm(AlarmId::variable_unknown, where, std::string_view(m.def.grammar.given_names->name_of(number))));
}

std::optional<FurtherVariable> further_variable(const VariableRow& row, std::uint32_t number, std::uint32_t index) {
  if (row.kind == VariableKind::common_further) return FurtherVariable{true, number};
  if (row.kind == VariableKind::common_again) return FurtherVariable{false, static_cast<std::uint32_t>(row.arg) + index - row.first_index};
  return std::nullopt;
}

double read_further(const BlockContext& m, FurtherVariable variable) {
  const MacroVariables& variables = macro_b_of(m).variables;
  return variable.own ? variables.further(variable.number) : variables.common(static_cast<int>(variable.number));
}

void write_further(BlockContext& m, FurtherVariable variable, double value) {
  MacroB& macros = macro_b_of(m);
  macros.endless.note_change();
  if (variable.own) macros.variables.set_further(variable.number, value);
  else macros.variables.set_common(static_cast<int>(variable.number), value);
}

double cutting_unit(const VariableRow& row) { return row.arg == 1 ? ms_of_hour : 1; }

double cutting_unit(const ControlDef& def) {
  for (const VariableRow& row : def.variables)
    if (row.kind == VariableKind::cutting_clock) return cutting_unit(row);
  return 1;
}

/// Returns the value of a timer in seconds. INFERRED: a run is one machining cycle and one part, and no part was made before the run.
double timer(const BlockContext& m, const VariableRow& row) {
  switch (static_cast<TimerOf>(row.arg)) {
    case TimerOf::power_on:
    case TimerOf::cycle_start:
    case TimerOf::this_part: return macro_b_of(m).now_ms / ms_of_second;
    case TimerOf::feed: return macro_b_of(m).cutting_ms / ms_of_second;
    default: return 0;
  }
}

double operator_switch(const BlockContext& m, const VariableRow& row) {
  switch (row.arg) {
    case block_delete: return std::any_of(m.skip_switches.begin(), m.skip_switches.end(), [](bool on) { return on; });
    case stop_at_m1: return m.optional_stop_on;
    default: return 0;
  }
}

}  // namespace kadr::macro_b
