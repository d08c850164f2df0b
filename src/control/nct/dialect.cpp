// Those functions of control/dialect.h that the NCT implements in its own way: coupled axes, tools, waiting codes.

#include <utility>

#include "config/setup/setup_keys.h"
#include "control/fanuc/words/coordinates.h"
#include "control/interpreter.h"
#include "control/nct/axes/coupling.h"
#include "control/nct/axes/drives.h"
#include "control/nct/nct.h"
#include "control/nct/waiting.h"

namespace kadr {

std::unique_ptr<Dialect> make_nct_dialect(BlockContext& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons) {
  return std::make_unique<nct::Nct>(m, setup, limits, std::move(commons));
}

namespace nct {

void Nct::started(Emitter& m) {
  couple_gantries(m);
  // The machine's logic may have switched on a signal that couples, exchanges or parks an axis before the start (20.2 to 20.4).
  for (const auto& [name, value] : signals)
    if (const AxisSignal signal = axis_signal(name); value != 0 && !signal.axis.empty())
      couple_axis(m, std::string(signal.axis), signal.link, true);
}

/// Copies from another channel the tables that all channels share: tools, pockets and forms (12.3).
void Nct::take_common(BlockContext& m, const Dialect& from) {
  tools.take_tables(static_cast<const Nct&>(from).tools);
  Fanuc::take_common(m, from);
}

Result<bool> Nct::finish(Interpreter& m) {
  if (!drives.requests.empty()) execute_requests(m);
  return Fanuc::finish(m);
}

Status Nct::may_move(const BlockContext& m, AxisMask named) const { return not_following(m, named); }

/// Completes a motion: followers move with their masters, and parked axes keep their positions.
void Nct::note_motion(Emitter& m, Motion& motion) {
  fanuc::note_motion(m, motion);
  if (following != 0) follow(m, motion);
  if (drives.parked != 0) keep_parked(m, motion);
  if (!spindle_axes.empty()) watch_spindle_axes(m, motion.named);
}

Status Nct::accept_answer(Emitter& m, const ProbeAnswer& at) {
  const Status taken = Fanuc::accept_answer(m, at);
  follow_from_here(m);
  return taken;
}

/// Executes an M code. The control itself executes a waiting code, which is not passed to the machine (14.5).
Status Nct::machine_code(Interpreter& m, const Call& call) {
  const auto waits = waiting_code(m, call);
  if (!waits) return fail(waits.error());
  return *waits ? Status() : Fanuc::machine_code(m, call);
}

// ---- the tool tables: the values that system variables return (12.5.3), and the contents after a run

bool Nct::consume_touched_tables() {
  bool touched = Fanuc::consume_touched_tables();
  touched = !tools.take_changed_rows().empty() || touched;
  touched = !tools.take_changed_places().empty() || touched;
  return !tools.take_changed_forms().empty() || touched;
}

std::optional<double> Nct::table_value(Emitter& m, const FoundVariable& variable) const {
  const VariableRow& row = *variable.row;
  if (row.kind == VariableKind::tool_data)
    return tools.spindle_data(static_cast<int>(tool_magazine), static_cast<int>(variable.number)).value_or(vacant);
  if (row.kind == VariableKind::tool_magazine && row.works) return tool_magazine;
  return Fanuc::table_value(m, variable);
}

Result<bool> Nct::write_table(Emitter& m, const FoundVariable& variable, double value, Span where) {
  if (variable.row->kind != VariableKind::tool_magazine) return Fanuc::write_table(m, variable, value, where);
  if (!ToolManagement::check_magazine(value)) return fail(alarm(AlarmId::magazine_number, where, value));
  tool_magazine = value;
  return true;
}

RunState Nct::run_state(const Emitter& m) const {
  RunState s = Fanuc::run_state(m);
  s.tables.tool_table = tools.rows();
  s.tables.place_table = tools.places();
  s.tables.form_table = tools.forms();
  return s;
}

}  // namespace nct
}  // namespace kadr
