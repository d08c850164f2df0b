// What must survive power-off and has changed: rows for the state file (spec/nct/09, 12.3, 23.1.4, 23.1.9, 24.1). For control/nct/memory.

#include "control/macro_b/variables/changes.h"

#include "control/interpreter.h"
#include "control/macro_b/variables/further_variables.h"
#include "control/nct/nct.h"

namespace kadr::nct {
namespace {

constexpr double cutting_step_ms = 1000;  // the cutting time is kept to a second

using Rows = std::map<std::pair<StateTable, std::string>, StateValue>;

/// Rows of all tables as they are now.
Rows rows_now(Interpreter& m) {
  Setup tables = nct_of(m).run_state(m).tables;
  tables.variables.clear();
  Rows rows;
  for (StateRow& row : rows_of(tables)) rows[{row.table, std::move(row.key)}] = std::move(row.value);
  return rows;
}

/// Has a table been written to since the last question?
bool tables_touched(Nct& nct) {
  bool touched = std::exchange(nct.tables_changed, false);
  touched = !std::exchange(nct.changed_offsets, {}).empty() || touched;
  touched = !nct.tools.take_changed_rows().empty() || touched;
  touched = !nct.tools.take_changed_places().empty() || touched;
  return !nct.tools.take_changed_forms().empty() || touched;
}

void note_number(StateChanges& changes, const char* name, double now, double& saved) {
  if (now == saved) return;
  changes.rows.push_back({StateTable::variables, name, now});
  saved = now;
}

}  // namespace

StateChanges Changes::take(Interpreter& m) {
  Nct& nct = nct_of(m);
  StateChanges changes;
  for (int n = first_kept; all_ && n <= last_common; ++n)
    if (!is_vacant(nct.variables.common(n)))
      changes.rows.push_back({StateTable::variables, "#" + std::to_string(n), nct.variables.common(n)});
  for (const std::uint16_t n : nct.variables.take_changed()) {
    const double value = nct.variables.common(n);
    changes.rows.push_back({StateTable::variables, "#" + std::to_string(n), is_vacant(value) ? StateValue() : StateValue(value)});
  }
  std::set<std::uint32_t> further = nct.variables.take_changed_further();
  for (const auto& row : nct.variables.all_further())
    if (all_) further.insert(row.first);
  for (const std::uint32_t n : further) {
    const double value = nct.variables.further(n);
    changes.rows.push_back({StateTable::variables, "#" + std::to_string(n), is_vacant(value) ? StateValue() : StateValue(value)});
  }
  note_number(changes, "#3901", nct.state.parts_done, parts_done_);
  note_number(changes, "#3902", nct.parts_required, parts_required_);
  if (nct.cutting_ms - cutting_ms_ >= cutting_step_ms || nct.cutting_ms < cutting_ms_) {
    if (nct.cutting_ms != cutting_ms_) changes.rows.push_back({StateTable::variables, "#3002", nct.cutting_ms / cutting_unit(m.def)});
    cutting_ms_ = nct.cutting_ms;
  }
  const bool touched = tables_touched(nct);
  if (!std::exchange(all_, false) && !touched && parameters_ == nct.parameters.version()) return changes;
  parameters_ = nct.parameters.version();
  Rows now = rows_now(m);
  for (const auto& [key, value] : now)
    if (const auto saved = tables_.find(key); saved == tables_.end() || saved->second != value)
      changes.rows.push_back({key.first, key.second, value});
  for (const auto& [key, value] : tables_)
    if (!now.contains(key)) changes.rows.push_back({key.first, key.second, {}});
  tables_ = std::move(now);
  return changes;
}

}  // namespace kadr::nct
