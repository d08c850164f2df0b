// Implements the functions that the interpreter calls in a dialect (control/dialect.h) with the functions of this folder, and processes
// what the machine's logic reports about spindles (spec/nct 11.7, 11.8).

#include <utility>

#include "control/fanuc/dialect/blocks.h"
#include "control/fanuc/drilling/drilling.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/five_axis/five_axis_functions.h"
#include "control/fanuc/geometry/arcs.h"
#include "control/fanuc/geometry/automatic_geometry.h"
#include "control/fanuc/geometry/sides.h"
#include "control/fanuc/modes/measuring.h"
#include "control/fanuc/turning/turning.h"
#include "control/fanuc/words/coordinates.h"
#include "control/interpreter.h"
#include "control/state/search_rules.h"

namespace kadr::fanuc {

Result<bool> Fanuc::finish(Interpreter& m) { return finishing.empty() ? Result<bool>(false) : end_contour(m); }

void Fanuc::note_skip_mark(Emitter& m) { fanuc::note_skip_mark(m); }

Result<bool> Fanuc::takes_block(Interpreter& m) {
  const auto done = before_plan(m);
  if (done && !*done && (MacroB::state.active_modal_calls != 0 || !pending.empty()))
    m.keep_flow_place();  // stores the position in the program for the alarm that a macro call after the block may raise
  return done;
}

std::int16_t Fanuc::motion_row(const BlockContext& m) const { return fanuc::motion_row(m); }

BlockChanges Fanuc::changes_of(const BlockContext& m, const Plan& plan) const {
  if (m.modal.polar_data || drilling_on(m) || !m.transform.identity || m.keeps_flow_place()) return BlockChanges::anything;
  if (controls_lines(m)) return BlockChanges::anything;
  return plan.moves_and_feeds || plan.calls_only ? BlockChanges::little : BlockChanges::anything;
}

void Fanuc::before_function(Emitter& m, Function function) {
  if (state.compensates && traits_of(function).is(function_fact::breaks_contour)) m.emit(CompensationBreak{});
}

void Fanuc::after_code(Interpreter& m, const CodeRow& row, std::int32_t code) { note_code(m, row, code); }

Status Fanuc::after_block(Interpreter& m) { return fanuc::after_block(m); }

Status Fanuc::target(const BlockContext& m, Axes& to, AxisMask& named) const { return fanuc::target(m, to, named); }

bool Fanuc::shapes_lines(const BlockContext& m) const { return has_geometry_words(m) || has_corner_words(m) || controls_lines(m); }

Status Fanuc::straight(Emitter& m, const Call& call, MotionKind kind) {
  return has_geometry_words(m) || has_corner_words(m) ? shaped_line(m, call, kind) : tip_control_line(m, call, kind);
}

bool Fanuc::only_shifts(const BlockContext& m) const { return only_shifts_length(m); }

Status Fanuc::arc(Emitter& m, const Call& call, Turn turn) { return fanuc::arc(m, call, turn); }

bool Fanuc::lines_follow(const BlockContext& m) const {
  const bool counts_inches = m.modal.inch && !m.def.grammar.least_increments.empty();
  const bool plain_motion = state.side_step == SideStep::none && state.compensates == (m.modal.radius_side != 0) && m.modal.smoothing < 2 &&
                            !drilling_on(m) && following == 0 && spindle_axes.empty() && finishing.empty() && !watches_words(m);
  return !counts_inches && !m.modal.polar_data && plain_motion && words_follow();
}

/// Returns the axes that roll over: their position restarts at 0 after a full period (5.6). Their travel is computed separately from that
/// of other axes.
AxisMask Fanuc::rolling_axes(const BlockContext& m) const {
  AxisMask rolling = 0;
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if (settings.axes[a].rolls && (m.def.rotary >> a & 1u) != 0) rolling |= AxisMask{1} << a;
  return rolling;
}

/// Returns the rule for arcs that the fast code for simple blocks executes. I, J, K belong to X, Y, Z whichever axes the plane has (4.3),
/// so arcs in a plane of other axes need the general code.
ArcRule Fanuc::arc_rule(const BlockContext& m) const {
  const bool usual_axes = m.modal.axes == axes_of(m.modal.plane);
  return {usual_axes, usual_axes, settings.centers_absolute, false, settings.radius_difference, m.def.behaviour.arc_angle_even};
}

Result<PlaneArc> Fanuc::arc_of_radius(Emitter&, const ArcRule&, const ArcEnds& ends, double radius) const {
  return arc_by_short_radius(ends, radius, settings.radius_shortfall);
}

void Fanuc::count_words(BlockContext& m) const { count_increments(m); }

void Fanuc::note_line(BlockContext& m) {
  if (m.block->marker == Marker::label && m.def.grammar.colon_is_label && m.program().depth() == 0)
    MacroB::state.words.o = m.block->label;                          // last program number O (spec/fanuc 5.8)
  if (m.block->has_number) MacroB::state.words.n = m.block->number;  // last block number N (23.1.14)
  if (m.block->calls_macro) return;  // if the words of the block are arguments of a macro, their values are not recorded
  if (const Word* const code = m.block->find('M'); code != nullptr) MacroB::state.words.m = code->value;
  if ((m.block->letters & letter_bit('F')) == 0) return;
  MacroB::state.words.f = m.block->find('F')->value;
  state.thread_lead = 0;
}

Status Fanuc::surface_line(Emitter& m, MotionKind kind, const Axes& programmed, AxisMask named) {
  return fanuc::surface_line(m, kind, programmed, named);
}

void Fanuc::note_motion(Emitter& m, Motion& motion) {
  fanuc::note_motion(m, motion);
  if (!spindle_axes.empty()) watch_spindle_axes(m, motion.named);
}

double Fanuc::inch_feed(const BlockContext& m, const Motion& motion, const Axes& from) const { return fanuc::inch_feed(m, motion, from); }

void Fanuc::refresh_frames(Emitter& m) { fanuc::refresh_frames(m); }

Axes Fanuc::shift_of_origin(const BlockContext& m) const { return fanuc::shift_of_origin(m); }

void Fanuc::roll(const BlockContext& m, Axes& positions) const { roll_positions(m, positions); }

Status Fanuc::accept_answer(Emitter& m, const ProbeAnswer& at) { return fanuc::accept_answer(m, at); }

// ---- reports of the machine

void Fanuc::synchronise(int slave, int master) {
  for (int n = 1; n <= static_cast<int>(max_spindles); ++n) {
    if (slave != n && slave != 0) continue;
    SpindleState& s = spindle(n);
    s.master = master;
    if (master < 1 || master > static_cast<int>(max_spindles)) continue;
    SpindleState& leading =
        // 11.7.4: the position loops of two synchronised spindles are closed, and the slave turns at the speed of its master
        spindle(master);
    s.rpm = leading.rpm;
    s.dir = leading.dir;
    s.loop_closed = leading.loop_closed = true;
  }
}

void Fanuc::convert_spindle(int number, bool to_axis) {
  if (number < 1 || number > static_cast<int>(max_spindles)) return;
  SpindleState& s = spindle(number);
  s.dir = SpindleDir::stop;
  s.master = 0;
  s.loop_closed = to_axis;
  s.referenced = false;
}

/// Returns the exclusive groups of M codes, whose first and last codes are in N1341 to N1372; a group with values of 0 does not exist.
SearchRules Fanuc::search_rules() const {
  SearchRules rules{{}, settings.change_on_m6};
  for (const auto& group : settings.m_groups)
    if (group.second > 0) rules.groups.push_back(group);
  return rules;
}

// ---- functions that the macro level, MacroB, calls

Axes Fanuc::before_transform(const BlockContext& m) const { return fanuc::before_transform(m); }

}  // namespace kadr::fanuc
