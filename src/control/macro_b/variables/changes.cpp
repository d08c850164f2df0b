// Finds the values that have changed and must survive power-off, and returns them as rows for the state file (spec/nct/09, 12.3, 23.1.4,
// 23.1.9, 24.1). Used by control/macro_b/memory.

#include "control/macro_b/variables/changes.h"

#include "control/emitter.h"
#include "control/macro_b/macro_b.h"
#include "control/macro_b/variables/further_variables.h"

namespace kadr::macro_b {
namespace {

constexpr double cutting_step_ms = 1000;  // the cutting time is saved whenever it has increased by one second

using Rows = std::map<std::pair<StateTable, std::string>, StateValue>;

/// Returns the present rows of all tables except the variables.
Rows rows_now(Emitter& m) {
  Setup tables = macro_b_of(m).run_state(m).tables;
  tables.variables.clear();
  Rows rows;
  for (StateRow& row : rows_of(tables)) rows[{row.table, std::move(row.key)}] = std::move(row.value);
  return rows;
}

void note_number(StateChanges& changes, const char* name, double now, double& saved) {
  if (now == saved) return;
  changes.rows.push_back({StateTable::variables, name, now});
  saved = now;
}

}  // namespace

StateChanges Changes::take(Emitter& m) {
  MacroB& macros = macro_b_of(m);
  StateChanges changes;
  for (int n = first_permanent; all_ && n <= last_common; ++n)
    if (!is_vacant(macros.variables.common(n)))
      changes.rows.push_back({StateTable::variables, "#" + std::to_string(n), macros.variables.common(n)});
  for (const std::uint16_t n : macros.variables.take_changed()) {
    const double value = macros.variables.common(n);
    changes.rows.push_back({StateTable::variables, "#" + std::to_string(n), is_vacant(value) ? StateValue() : StateValue(value)});
  }
  std::set<std::uint32_t> further = macros.variables.take_changed_further();
  for (const auto& row : macros.variables.all_further())
    if (all_) further.insert(row.first);
  for (const std::uint32_t n : further) {
    const double value = macros.variables.further(n);
    changes.rows.push_back({StateTable::variables, "#" + std::to_string(n), is_vacant(value) ? StateValue() : StateValue(value)});
  }
  note_number(changes, "#3901", macros.state.parts_done, parts_done_);
  note_number(changes, "#3902", macros.parts_required, parts_required_);
  if (macros.cutting_ms - cutting_ms_ >= cutting_step_ms || macros.cutting_ms < cutting_ms_) {
    if (macros.cutting_ms != cutting_ms_) changes.rows.push_back({StateTable::variables, "#3002", macros.cutting_ms / cutting_unit(m.def)});
    cutting_ms_ = macros.cutting_ms;
  }
  const bool touched = macros.consume_touched_tables();
  if (!std::exchange(all_, false) && !touched && parameters_ == macros.parameters.version()) return changes;
  parameters_ = macros.parameters.version();
  Rows now = rows_now(m);
  for (const auto& [key, value] : now)
    if (const auto saved = tables_.find(key); saved == tables_.end() || saved->second != value)
      changes.rows.push_back({key.first, key.second, value});
  for (const auto& [key, value] : tables_)
    if (!now.contains(key)) changes.rows.push_back({key.first, key.second, {}});
  tables_ = std::move(now);
  return changes;
}

}  // namespace kadr::macro_b
