// What all controls do where a dialect says nothing of its own: ISO 6983.

#include "control/dialect.h"

#include <utility>

#include "control/contour.h"
#include "control/machinery.h"

namespace kadr {

bool Dialect::start(Machinery&, const Setup&) { return false; }
void Dialect::take_setup(Machinery&, const Setup&) {}
void Dialect::started(Machinery&) {}
bool Dialect::end_program(Machinery&) { return false; }
bool Dialect::lose_power(Machinery&) { return false; }
void Dialect::add_variables(Machinery&, Ending&, const std::vector<std::string>&) {}
StateChanges Dialect::take_changes(Machinery&) { return {}; }
Result<bool> Dialect::finish(Machinery&) { return false; }
bool Dialect::reads_clock(const Block&) const { return false; }
void Dialect::note_skip_mark(Machinery&) {}
Result<bool> Dialect::interrupt(Machinery&, BlockMoment) { return false; }
Status Dialect::statement(Machinery&) { return {}; }
void Dialect::begin_block(Machinery&) {}
Result<bool> Dialect::takes_block(Machinery& m) {
  KADR_TRY(m.take_words());
  return false;
}
std::int16_t Dialect::motion_row(const Machinery& m) const { return m.modal.motion_row; }
BlockChanges Dialect::changes_of(const Machinery& m, const Plan& plan) const { return m.changes_of_block(plan); }
void Dialect::before_function(Machinery&, Function) {}
void Dialect::after_code(Machinery&, const CodeRow&, std::int32_t) {}
Status Dialect::after_block(Machinery&) { return {}; }
void Dialect::note_shadowed(Machinery&, std::uint32_t, Span) {}
void Dialect::keep(Machinery&) {}
void Dialect::take_back(Machinery&) {}
void Dialect::taken_back(Machinery&) {}
void Dialect::note_fault(Machinery&, bool) {}
bool Dialect::leave_call(Machinery&) { return false; }
Status Dialect::target(const Machinery& m, Axes& to, AxisMask& named) const { return m.axis_words(to, named); }
bool Dialect::adds_to_motion(const Machinery&) const { return false; }
Result<AxisMask> Dialect::add_to_motion(Machinery&) { return AxisMask{0}; }
bool Dialect::shapes_lines(const Machinery&) const { return false; }
Status Dialect::straight(Machinery&, const Call&, MotionKind) { return {}; }
bool Dialect::only_shifts(const Machinery&) const { return false; }
Status Dialect::arc(Machinery& m, const Call& call, Turn turn) { return m.plain_arc(turn, call.where); }
Status Dialect::surface_line(Machinery&, MotionKind, const Axes&, AxisMask) { return {}; }
Status Dialect::may_move(const Machinery&, AxisMask) const { return {}; }
void Dialect::note_motion(Machinery& m, Motion& motion) {
  if (m.modal.contour != ContourPhase::off) note_contour(m, motion, m.moved_from);
}
double Dialect::inch_feed(const Machinery&, const Motion& motion, const Axes&) const { return motion.feed; }
void Dialect::note_feed(Machinery&) {}
SurfaceSpeed Dialect::surface_speed(const Machinery& m) const { return m.speed_by_x(); }
void Dialect::refresh_frames(Machinery& m) { m.frames_by_tables(); }
void Dialect::roll(const Machinery&, Axes&) const {}
Status Dialect::take_answer(Machinery& m, const ProbeAnswer& answer) { return m.note_answer(answer); }
Status Dialect::machine_code(Machinery& m, const Call& call) { return m.emit_machine_function(call); }
Result<double> Dialect::read_variable(Machinery& m, double number, Span where) const { return m.variables.variable(number, where); }
Result<double> Dialect::number_of_element(const Machinery&, double, double, Span) const { return 0.0; }
Result<double> Dialect::control_value(Machinery&, double, double, double, Span) const { return 0.0; }

std::unique_ptr<Dialect> make_dialect(Machinery& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons) {
  switch (m.def.dialect) {
    case DialectId::s2c42: return make_s2c42_dialect();
    case DialectId::correctors: return make_correctors_dialect(m, setup);
    case DialectId::nct: return make_nct_dialect(m, setup, limits, std::move(commons));
    case DialectId::iso: break;
  }
  return nullptr;
}

}  // namespace kadr
