// What all controls do where a dialect says nothing of its own: ISO 6983.

#include "control/dialect.h"

#include <utility>

#include "control/functions/contour.h"
#include "control/interpreter.h"

namespace kadr {

bool Dialect::start(Interpreter&, const Setup&) { return false; }
void Dialect::take_setup(Interpreter&, const Setup&) {}
std::pair<double, double> Dialect::limits_by_file(std::size_t) const { return {-1e300, 1e300}; }
void Dialect::started(Interpreter&) {}
bool Dialect::end_program(Interpreter&) { return false; }
bool Dialect::lose_power(Interpreter&) { return false; }
void Dialect::add_variables(Interpreter&, Ending&, const std::vector<std::string>&) {}
StateChanges Dialect::take_changes(Interpreter&) { return {}; }
Result<bool> Dialect::finish(Interpreter&) { return false; }
bool Dialect::reads_clock(const Block&) const { return false; }
void Dialect::note_skip_mark(Interpreter&) {}
Result<bool> Dialect::interrupt(Interpreter&, BlockMoment) { return false; }
Result<bool> Dialect::statement(Interpreter&) { return true; }
void Dialect::begin_block(Interpreter&) {}
Status Dialect::restore(Interpreter&, const DialectState&) { return {}; }
Result<bool> Dialect::takes_block(Interpreter& m) {
  KADR_TRY(m.take_words());
  return false;
}
std::int16_t Dialect::motion_row(const Interpreter& m) const { return m.modal.motion_row; }
BlockChanges Dialect::changes_of(const Interpreter& m, const Plan& plan) const { return m.changes_of_block(plan); }
void Dialect::before_function(Interpreter&, Function) {}
void Dialect::after_code(Interpreter&, const CodeRow&, std::int32_t) {}
Status Dialect::after_block(Interpreter&) { return {}; }
Result<bool> Dialect::sign_of_file(Interpreter&) { return false; }
Result<bool> Dialect::end_of_file(Interpreter&) { return false; }
Status Dialect::comments(Interpreter& m) {
  m.show_messages();
  return {};
}
void Dialect::reword(const Interpreter&, AlarmReport&) const {}
Status Dialect::write_variable(Interpreter& m, double number, double value, Span where) { return m.variables.set(number, value, where); }
void Dialect::note_shadowed(Interpreter&, std::uint32_t, Span) {}
void Dialect::keep(Interpreter&) {}
void Dialect::take_back(Interpreter&) {}
void Dialect::taken_back(Interpreter&) {}
void Dialect::note_fault(Interpreter&, bool) {}
bool Dialect::leave_call(Interpreter&) { return false; }
Status Dialect::target(const Interpreter& m, Axes& to, AxisMask& named) const { return m.axis_words(to, named); }
bool Dialect::adds_to_motion(const Interpreter&) const { return false; }
Result<AxisMask> Dialect::add_to_motion(Interpreter&) { return AxisMask{0}; }
bool Dialect::shapes_lines(const Interpreter&) const { return false; }
Status Dialect::straight(Interpreter&, const Call&, MotionKind) { return {}; }
bool Dialect::only_shifts(const Interpreter&) const { return false; }
Status Dialect::arc(Interpreter& m, const Call& call, Turn turn) { return m.plain_arc(turn, call.where); }
Status Dialect::surface_line(Interpreter&, MotionKind, const Axes&, AxisMask) { return {}; }
Status Dialect::may_move(const Interpreter&, AxisMask) const { return {}; }
void Dialect::note_motion(Interpreter& m, Motion& motion) {
  if (m.modal.contour != ContourPhase::off) note_contour(m, motion, m.moved_from);
}
double Dialect::inch_feed(const Interpreter& m, const Motion& motion, const Axes& from) const { return feed_in_inches(m, motion, from); }
ArcRule Dialect::arc_rule(const Interpreter& m) const { return m.plain_arc_rule(); }
void Dialect::note_feed(Interpreter&) {}
const WrittenFiles& Dialect::files_written() const {
  static const WrittenFiles none;
  return none;
}
SurfaceSpeed Dialect::surface_speed(const Interpreter& m) const { return m.speed_by_x(); }
void Dialect::refresh_frames(Interpreter& m) { m.frames_by_tables(); }
Axes Dialect::shift_of_origin(const Interpreter& m) const { return m.shift_by_tables(); }
void Dialect::roll(const Interpreter&, Axes&) const {}
Status Dialect::take_answer(Interpreter& m, const ProbeAnswer& answer) { return m.note_answer(answer); }
Status Dialect::machine_code(Interpreter& m, const Call& call) { return m.emit_machine_function(call); }
Result<double> Dialect::read_variable(Interpreter& m, double number, Span where) const { return m.variables.variable(number, where); }
Result<double> Dialect::number_of_element(const Interpreter&, double, double, Span) const { return 0.0; }
Result<double> Dialect::control_value(Interpreter&, double, double, double, Span) const { return 0.0; }

std::unique_ptr<Dialect> make_iso_dialect() {
  struct Iso final : Dialect {
    bool drills_plainly() const override { return true; }
  };
  return std::make_unique<Iso>();
}

std::unique_ptr<Dialect> make_dialect(Interpreter& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons) {
  switch (m.def.dialect) {
    case DialectId::s2c42: return make_s2c42_dialect();
    case DialectId::correctors: return make_correctors_dialect(m, setup);
    case DialectId::grbl: return make_grbl_dialect(setup);
    case DialectId::linuxcnc: return make_linuxcnc_dialect(m, setup, limits);
    case DialectId::nct: return make_nct_dialect(m, setup, limits, std::move(commons));
    case DialectId::mach3: return make_mach3_dialect(limits);
    case DialectId::iso: break;
  }
  return make_iso_dialect();
}

}  // namespace kadr
