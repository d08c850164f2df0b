// The default behaviour of a control, by ISO 6983. It applies wherever the dialect of the control does not override a function.

#include "control/dialect.h"

#include <utility>

#include "control/functions/cutter_compensation.h"
#include "control/interpreter.h"

namespace kadr {

bool ProgramDialect::start(Interpreter&, const Setup&) { return false; }
void ProgramDialect::take_setup(Emitter&, const Setup&) {}
std::pair<double, double> ProgramDialect::limits_by_file(std::size_t) const { return {-1e300, 1e300}; }
void ProgramDialect::started(Emitter&) {}
bool ProgramDialect::end_program(Interpreter&) { return false; }
bool ProgramDialect::lose_power(Interpreter&) { return false; }
void VariableDialect::add_variables(Emitter&, FinalState&, const std::vector<std::string>&) {}
StateChanges ProgramDialect::take_changes(Interpreter&) { return {}; }
Result<bool> BlockDialect::finish(Interpreter&) { return false; }
bool BlockDialect::reads_clock(const Block&) const { return false; }
void BlockDialect::note_skip_mark(Emitter&) {}
Result<bool> BlockDialect::interrupt(Interpreter&, BlockMoment) { return false; }
Result<bool> BlockDialect::statement(Interpreter&) { return true; }
void BlockDialect::begin_block(Emitter&) {}
Status ProgramDialect::restore(BlockContext&, const DialectState&) { return {}; }
Result<bool> BlockDialect::takes_block(Interpreter& m) {
  KADR_TRY(m.take_words());
  return false;
}
std::int16_t BlockDialect::motion_row(const BlockContext& m) const { return m.modal.motion_row; }
BlockChanges BlockDialect::changes_of(const BlockContext& m, const Plan& plan) const { return m.changes_of_block(plan); }
void BlockDialect::before_function(Emitter&, Function) {}
void BlockDialect::after_code(Interpreter&, const CodeRow&, std::int32_t) {}
Status BlockDialect::after_block(Interpreter&) { return {}; }
Result<bool> ProgramDialect::sign_of_file(Interpreter&) { return false; }
Result<bool> ProgramDialect::end_of_file(BlockContext&) { return false; }
Status BlockDialect::comments(Emitter& m) {
  m.show_messages();
  return {};
}
void ProgramDialect::reword(const BlockContext&, AlarmReport&) const {}
Status VariableDialect::write_variable(BlockContext& m, double number, double value, Span where) {
  return m.variables.set(number, value, where);
}
void BlockDialect::note_shadowed(Emitter&, std::uint32_t, Span) {}
void BlockDialect::keep(BlockContext&) {}
void BlockDialect::undo_block(BlockContext&) {}
void BlockDialect::block_undone(Emitter&) {}
void ProgramDialect::note_fault(Interpreter&, bool) {}
bool ProgramDialect::leave_call(Interpreter&) { return false; }
Status MotionDialect::target(const BlockContext& m, Axes& to, AxisMask& named) const { return m.axis_words(to, named); }
bool MotionDialect::adds_to_motion(const BlockContext&) const { return false; }
Result<AxisMask> MotionDialect::add_to_motion(Emitter&) { return AxisMask{0}; }
bool MotionDialect::shapes_lines(const BlockContext&) const { return false; }
Status MotionDialect::straight(Emitter&, const Call&, MotionKind) { return {}; }
bool MotionDialect::only_shifts(const BlockContext&) const { return false; }
Status MotionDialect::arc(Emitter& m, const Call& call, Turn turn) { return m.plain_arc(turn, call.where); }
Status MotionDialect::surface_line(Emitter&, MotionKind, const Axes&, AxisMask) { return {}; }
Status MotionDialect::may_move(const BlockContext&, AxisMask) const { return {}; }
void MotionDialect::note_motion(Emitter& m, Motion& motion) {
  if (m.modal.contour != CompensationPhase::off) note_compensation(m, motion, m.moved_from);
}
double MotionDialect::inch_feed(const BlockContext& m, const Motion& motion, const Axes& from) const {
  return feed_in_inches(m, motion, from);
}
ArcRule MotionDialect::arc_rule(const BlockContext& m) const { return m.plain_arc_rule(); }
Result<PlaneArc> MotionDialect::arc_of_center(Emitter&, const ArcRule& rule, const ArcEnds& ends, Vec2 center) const {
  return arc_around(ends.from, ends.to, center, ends.turn, rule.difference);
}
Result<PlaneArc> MotionDialect::arc_of_radius(Emitter&, const ArcRule& rule, const ArcEnds& ends, double radius) const {
  return arc_by_radius(ends.from, ends.to, radius, ends.turn, rule.difference);
}
void MotionDialect::note_feed(BlockContext&) {}
const WrittenFiles& ProgramDialect::files_written() const {
  static const WrittenFiles none;
  return none;
}
SurfaceSpeed MotionDialect::surface_speed(const BlockContext& m) const { return m.speed_by_x(); }
void FrameDialect::refresh_frames(Emitter& m) { m.frames_by_tables(); }
Axes FrameDialect::shift_of_origin(const BlockContext& m) const { return m.shift_by_tables(); }
void FrameDialect::roll(const BlockContext&, Axes&) const {}
Status MotionDialect::accept_answer(Emitter& m, const ProbeAnswer& answer) { return m.note_answer(answer); }
Status BlockDialect::machine_code(Interpreter& m, const Call& call) { return m.emit_machine_function(call); }
Result<double> VariableDialect::read_variable(Emitter& m, double number, Span where) const { return m.variables.variable(number, where); }
Result<double> VariableDialect::number_of_element(const BlockContext&, double, double, Span) const { return 0.0; }
Result<double> VariableDialect::control_value(BlockContext&, double, double, double, Span) const { return 0.0; }

std::unique_ptr<Dialect> make_iso_dialect() {
  struct Iso final : Dialect {
    bool drills_plainly() const override { return true; }
    bool lines_follow(const BlockContext&) const override { return true; }
    bool contour_follows(const BlockContext& m) const override { return continues_contour(m.modal); }
  };
  return std::make_unique<Iso>();
}

std::unique_ptr<Dialect> make_dialect(BlockContext& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons) {
  switch (m.def.dialect) {
    case DialectId::s2c42: return make_s2c42_dialect();
    case DialectId::correctors: return make_correctors_dialect(m, setup);
    case DialectId::grbl: return make_grbl_dialect(setup);
    case DialectId::linuxcnc: return make_linuxcnc_dialect(m, setup, limits);
    case DialectId::nct: return make_nct_dialect(m, setup, limits, std::move(commons));
    case DialectId::mach3: return make_mach3_dialect(limits);
    case DialectId::sinumerik: return make_sinumerik_dialect(m, setup, limits);
    case DialectId::heidenhain: return make_heidenhain_dialect(m, setup, limits);
    case DialectId::iso: break;
  }
  return make_iso_dialect();
}

}  // namespace kadr
