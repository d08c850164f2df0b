// Returns the tables of a control in the form of a set-up: the inverse of read_setup in control/interpreter_start. Used by
// Control::tables_now; tested by tests/panel/panel_tables_test.cpp, tests/panel_tables.py.

#include "control/tables_now.h"

#include <algorithm>

#include "config/setup/setup_names.h"
#include "control/emitter.h"

namespace kadr {
namespace {

constexpr std::size_t max_stored = 6;  // greatest number of axes that the variables of a fixture (work offset) store

Axes stored_zero(const BlockContext& m, std::uint32_t row) {
  if (!m.has_fixtures) return row < m.tables.zeros.size() ? m.tables.zeros[row] : Axes{};
  Axes values{};
  const std::uint32_t first = m.variables.first(VariableKind::fixture, row - 1);
  for (std::uint32_t a = 0; a < max_stored && a < m.axis_count; ++a) values[a] = m.variables.raw(first + a);
  return values;
}

void add_work_systems(const BlockContext& m, Setup& tables) {
  // table rows of the work offsets that are in the result already; one row may have two names: G54 is also G59 P1
  std::set<std::uint32_t> named;
  for (const WorkSystem& system : work_systems(m.def)) {
    const bool is_stored = system.row > 0 && (!m.has_fixtures || system.row <= m.def.behaviour.fixtures);
    if (!system.works || !is_stored || !named.insert(system.row).second) continue;
    const Axes zero = stored_zero(m, system.row);
    if (zero == Axes{}) continue;
    for (std::size_t a = 0; a < m.axis_count; ++a) tables.work_offsets[system.name][m.axis_names[a]] = zero[a];
  }
}

}  // namespace

Setup tables_of(const Emitter& m) {
  if (const MachineInterface* const side = m.dialect->machine_interface()) return side->run_state(m).tables;
  Setup tables;
  if (m.dialect->add_tables(m, tables)) return tables;
  for (std::size_t i = 1; i < m.tables.offsets.size(); ++i)
    if (m.tables.offsets[i] != ToolOffset{}) tables.offsets[int(i)] = m.tables.offsets[i];
  add_work_systems(m, tables);
  return tables;
}

}  // namespace kadr
