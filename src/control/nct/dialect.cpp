// What the interpreter asks a dialect (control/dialect.h), answered by the functions of this folder.

#include <algorithm>
#include <utility>

#include "config/setup_keys.h"
#include "control/fanuc/drilling/drilling.h"
#include "control/fanuc/five_axis/five_axis.h"
#include "control/fanuc/geometry/arcs.h"
#include "control/fanuc/geometry/automatic_geometry.h"
#include "control/fanuc/geometry/sides.h"
#include "control/fanuc/measuring.h"
#include "control/fanuc/turning/turning.h"
#include "control/fanuc/words/coordinates.h"
#include "control/interpreter.h"
#include "control/macro_b/blocks.h"
#include "control/macro_b/calls/calls.h"
#include "control/macro_b/calls/interrupt.h"
#include "control/macro_b/variables/system_variables.h"
#include "control/nct/axes/coupling.h"
#include "control/nct/nct.h"

namespace kadr {

std::unique_ptr<Dialect> make_nct_dialect(Interpreter& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons) {
  return std::make_unique<nct::Nct>(m, setup, limits, std::move(commons));
}

namespace nct {

void Nct::started(Interpreter& m) {
  couple_gantries(m);
  for (const auto& [name, value] : signals)  // what the machine's logic asks of axes from the start (20.2 to 20.4)
    if (const AxisSignal asked = axis_signal(name); value != 0 && !asked.axis.empty())
      couple_axis(m, std::string(asked.axis), asked.link, true);
}

bool Nct::end_program(Interpreter& m) {
  if (settings.part_code == 0) state.parts_done += 1;  // 13.1; else note_code
  reset_program(m);
  return true;
}

/// Power off and on (23.5).
bool Nct::lose_power(Interpreter& m) {
  ActionBatch unseen;
  ActionBatch* const kept = std::exchange(m.batch, &unseen);
  const bool keeps_codes = std::exchange(settings.keeps_codes, false);  // codes begin anew, whatever CLR says
  disengage(m);
  reset_program(m);
  couplings = {};
  end_drives(m);
  couple_gantries(m);
  settings.keeps_codes = keeps_codes;
  m.batch = kept;
  variables.power_off();
  clock_offset_ms = now_ms;
  tool_magazine = 10;
  answer = 0;
  return true;
}

void Nct::add_variables(Interpreter& m, Ending& ending, const std::vector<std::string>& watch) { nct::add_variables(m, ending, watch); }

/// Tables of tools, pockets, forms (12.3); parameters (24.1).
void Nct::take_common(Interpreter& m, const Dialect& from) {
  const Nct& other = static_cast<const Nct&>(from);
  tools.take_tables(other.tools);
  parameters.take(other.parameters);
  refresh_settings(m);
}

StateChanges Nct::take_changes(Interpreter& m) { return changes.take(m); }

Result<bool> Nct::finish(Interpreter& m) {
  if (!drives.asked.empty()) carry_out_asked(m);
  return finishing.empty() ? Result<bool>(false) : end_contour(m);
}

/// A clock variable stands in the block, or one by a computed number, or a text with variables (23.1.9). Its value must be that of the
/// moment: all actions before it are handed over first, and from then on each block's.
bool Nct::reads_clock(const Block& block) const {
  const StatementKind kind = block.statement.kind;
  if (kind == StatementKind::message || kind >= StatementKind::open_port) return true;
  for (const Instruction& i : block.code) {
    if (i.op == Op::variable) return true;
    if (!(i.number > last_common)) continue;
    const bool constant = i.op == Op::number || i.op == Op::variable_at;
    if (constant && std::find(clocks_.begin(), clocks_.end(), i.number) != clocks_.end()) return true;
  }
  return false;
}

void Nct::note_skip_mark(Interpreter& m) { nct::note_skip_mark(m); }

Result<bool> Nct::interrupt(Interpreter& m, BlockMoment moment) { return call_interrupt(m, moment); }

Result<bool> Nct::statement(Interpreter& m) { return run_statement(m); }

Result<bool> Nct::takes_block(Interpreter& m) {
  const auto done = before_plan(m);
  if (done && !*done && (state.active_modal_calls != 0 || !pending.empty())) m.keep_flow_place();  // a call after the block may fail
  return done;
}

std::int16_t Nct::motion_row(const Interpreter& m) const { return nct::motion_row(m); }

BlockChanges Nct::changes_of(const Interpreter& m, const Plan& plan) const {
  if (m.modal.polar_data || drilling_on(m) || !m.transform.identity || m.keeps_flow_place()) return BlockChanges::anything;
  if (leads_lines(m)) return BlockChanges::anything;
  return plan.moves_and_feeds || plan.calls_only ? BlockChanges::little : BlockChanges::anything;
}

void Nct::before_function(Interpreter& m, Function function) {
  if (state.compensates && traits_of(function).is(function_fact::breaks_contour)) m.emit(ContourBreak{});
}

void Nct::after_code(Interpreter& m, const CodeRow& row, std::int32_t code) { note_code(m, row, code); }

Status Nct::after_block(Interpreter& m) { return nct::after_block(m); }

bool Nct::leave_call(Interpreter& m) {
  nct::leave_call(m);
  return true;
}

Status Nct::target(const Interpreter& m, Axes& to, AxisMask& named) const { return nct::target(m, to, named); }

bool Nct::shapes_lines(const Interpreter& m) const { return has_geometry_words(m) || leads_lines(m); }

Status Nct::straight(Interpreter& m, const Call& call, MotionKind kind) {
  return has_geometry_words(m) ? shaped_line(m, call, kind) : led_line(m, call, kind);
}

bool Nct::only_shifts(const Interpreter& m) const { return only_shifts_length(m); }

Status Nct::arc(Interpreter& m, const Call& call, Turn turn) { return nct::arc(m, call, turn); }

bool Nct::lines_follow(const Interpreter& m) const {
  const bool counts_inches = m.modal.inch && !m.def.grammar.least_increments.empty();
  const bool plain_words =
      !counts_inches && !m.modal.polar_data && !settings.binds_codes && pending.empty() && state.data_mode == DataMode::none;
  const bool plain_motion = state.side_step == SideStep::none && !state.compensates && m.modal.smoothing < 2 && !drilling_on(m) &&
                            couplings.axes == 0 && drives.parked == 0 && spindle_axes.empty() && finishing.empty() && !watches_words(m);
  return plain_words && plain_motion && state.active_modal_calls == 0 && !single_block && !watches_blocks() && !interrupted.active;
}

/// They have a way of their own (5.6).
AxisMask Nct::rolling_axes(const Interpreter& m) const {
  AxisMask rolling = 0;
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if (settings.axes[a].rolls && (m.def.rotary >> a & 1u) != 0) rolling |= AxisMask{1} << a;
  return rolling;
}

/// I, J, K belong to X, Y, Z whatever axes the plane has (4.3); with others there Kadr looks closer.
ArcRule Nct::arc_rule(const Interpreter& m) const {
  return {m.modal.axes == axes_of(m.modal.plane), settings.centers_absolute, false, settings.radius_difference,
          m.def.behaviour.arc_angle_even};
}

void Nct::note_line(Interpreter& m) {
  if (m.block->marker == Marker::label && m.def.grammar.colon_is_label && m.flow.depth() == 0)
    state.words.o = m.block->label;                          // spec/fanuc 5.8
  if (m.block->has_number) state.words.n = m.block->number;  // 23.1.14
  if (m.block->calls_macro) return;                          // its words are arguments
  if (const Word* const code = m.block->find('M'); code != nullptr) state.words.m = code->value;
  if ((m.block->letters & letter_bit('F')) == 0) return;
  state.words.f = m.block->find('F')->value;
  state.thread_lead = 0;
}

Status Nct::surface_line(Interpreter& m, MotionKind kind, const Axes& programmed, AxisMask named) {
  return nct::surface_line(m, kind, programmed, named);
}

Status Nct::may_move(const Interpreter& m, AxisMask named) const { return not_following(m, named); }

void Nct::note_motion(Interpreter& m, Motion& motion) { nct::note_motion(m, motion); }

double Nct::inch_feed(const Interpreter& m, const Motion& motion, const Axes& from) const { return nct::inch_feed(m, motion, from); }

void Nct::refresh_frames(Interpreter& m) { nct::refresh_frames(m); }
Axes Nct::shift_of_origin(const Interpreter& m) const { return nct::shift_of_origin(m); }

void Nct::roll(const Interpreter& m, Axes& positions) const { roll_positions(m, positions); }

Status Nct::take_answer(Interpreter& m, const ProbeAnswer& at) { return nct::take_answer(m, at); }

Status Nct::machine_code(Interpreter& m, const Call& call) { return nct::machine_code(m, call); }

Result<double> Nct::read_variable(Interpreter& m, double number, Span where) const { return nct::read_variable(m, number, where); }

Result<double> Nct::number_of_element(const Interpreter& m, double symbol, double index, Span where) const {
  return nct::number_of_element(m, symbol, index, where);
}

Result<double> Nct::control_value(Interpreter& m, double number, double bit, double index, Span where) const {
  return read_parameter(m, number, bit, index, where);
}

}  // namespace nct
}  // namespace kadr
