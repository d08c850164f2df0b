// G81.8, G80.8: the electronic gearbox, by which a table with the workpiece follows a spindle (spec/nct/20 20.1).

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"
#include "control/nct/nct.h"

namespace kadr {
namespace {

constexpr double max_teeth = 1000, most_starts = 21;

tl::unexpected<Alarm> wrong_parameter(const Call& call, double number) {
  return fail(alarm(AlarmId::coupling_parameter, call.where, number));
}

/// Returns the index of the axis of this channel that a parameter of the gearbox names.
Result<std::size_t> axis_of(const BlockContext& m, const Call& call, const char* parameter) {
  const auto& store = macro_b_of(m).parameters;
  const std::string name = store.text(store.named(parameter));
  for (std::size_t a = 0; a < m.axis_count && !name.empty(); ++a)
    if (m.axis_names[a] == name) return a;
  return wrong_parameter(call, std::strtod(parameter, nullptr));
}

/// Returns the number of the spindle that N1801 names. If the set-up lists no spindle with this name, "S2" means spindle 2 and "S" means
/// the main spindle (INFERRED).
Result<int> master_of(const BlockContext& m, const Call& call, const std::string& name) {
  for (const auto& [number, named] : fanuc_of(m).spindle_names)
    if (!name.empty() && named == name) return number;
  if (name == "S") return fanuc_of(m).state.main_spindle;
  const int number = name.size() > 1 && name[0] == 'S' ? static_cast<int>(std::strtol(name.c_str() + 1, nullptr, 10)) : 0;
  if (number >= 1 && number <= static_cast<int>(fanuc::max_spindles)) return number;
  constexpr double parameter = 1801;
  return wrong_parameter(call, parameter);
}

/// Returns the ratio L / T of the gearbox: T is the number of teeth, L the number of starts. INFERRED: L0 raises an alarm.
Result<double> ratio(const BlockContext& m, const Call& call) {
  if (!m.has('T')) return fail(alarm(AlarmId::word_missing, call.where, 'T', call.row->code));
  const auto teeth = m.whole('T', 1, max_teeth);
  if (!teeth) return fail(teeth.error());
  const double starts = m.has('L') ? m.value('L') : 1;
  if (starts == 0 || std::floor(starts) != starts || std::fabs(starts) > most_starts)
    return fail(alarm(AlarmId::value_out_of_range, m.where('L'), 'L', starts));
  return starts / *teeth;
}

Status within(const BlockContext& m, char letter, double least, double most) {
  const double value = m.value(letter);
  if (value >= least && value <= most) return {};
  return fail(alarm(AlarmId::value_out_of_range, m.where(letter), letter, value));
}

/// Returns the additional rotation of the table in degrees per mm of travel along the gear's axis (20.1.3). INFERRED: its size follows from
/// the geometry of the gear, its sign is that of P.
Result<double> helix(const BlockContext& m, const Call& call, double teeth) {
  for (const char letter : {'Q', 'P'})
    if (!m.has(letter)) return fail(alarm(AlarmId::word_missing, call.where, letter, call.row->code));
  constexpr double module_least = 0.05, module_most = 60, pitch_least = 0.1, pitch_most = 508, right_angle = 90;
  KADR_TRY(m.modal.inch ? within(m, 'Q', pitch_least, pitch_most) : within(m, 'Q', module_least, module_most));
  KADR_TRY(within(m, 'P', -right_angle, right_angle));
  const double module = m.modal.inch ? mm_per_inch / m.value('Q') : m.value('Q');
  return 360 * sincos_deg(m.value('P')).sin / (std::numbers::pi * teeth * module);
}

}  // namespace

namespace functions {

/// G81.8 T L R Q P: couples the table to the spindle, or replaces the coupling. G81.8 Q P, while they are coupled: changes only the helix
/// compensation.
Status gear_on(Emitter& m, const Call& call) {
  nct::Nct& nct = nct_of(m);
  const auto& store = nct.parameters;
  const std::string master_name = store.text(store.named("1801"));
  const auto master = master_of(m, call, master_name);
  if (!master) return fail(master.error());
  const auto slave = axis_of(m, call, "1802");
  if (!slave) return fail(slave.error());
  KADR_TRY(nct::not_following(m, AxisMask{1} << *slave));
  nct::Gear gear = nct.state.gear;
  const bool only_helix = !m.has('T') && !m.has('L') && !m.has('R') && (m.has('Q') || m.has('P'));
  if (only_helix && !gear.on) return fail(alarm(AlarmId::gear_not_on, call.where));
  Couple couple{master_name, m.axis_names[*slave]};
  if (!only_helix) {
    const auto turns = ratio(m, call);
    if (!turns) return fail(turns.error());
    gear = {true, *turns, m.value('T')};
    const auto r = m.has('R') ? m.whole('R', 1, 2) : Result<std::uint32_t>(1);
    if (!r) return fail(r.error());
    if (*r == 2) couple.phase = m.position.machine[*slave];
  }
  if (m.has('Q') || m.has('P')) {
    const auto along = axis_of(m, call, "1803");
    if (!along) return fail(along.error());
    const auto turn = helix(m, call, gear.teeth);
    if (!turn) return fail(turn.error());
    couple.helix = *turn;
    couple.along = m.axis_names[*along];
  }
  const nct::SpindleState& spindle = nct.spindle(*master);
  const bool turns = spindle.dir == SpindleDir::cw || spindle.dir == SpindleDir::ccw;
  couple.ratio = gear.ratio;
  couple.master_number = *master;
  couple.rpm = turns ? spindle.rpm * gear.ratio : 0;
  // N1800 #1 FRS; INFERRED: if the bit is 1, the feed is per revolution of the workpiece
  couple.feeds_by_slave = store.bit(store.named("1800"), 1);
  nct.state.gear = gear;
  nct.stops_reading = true;
  m.emit(couple);
  return {};
}

/// G80.8: ends the coupling. The table stops; the spindle continues to turn.
Status gear_off(Emitter& m, const Call&) {
  nct::disengage(m);
  return {};
}

}  // namespace functions

namespace nct {

/// Retracts the axes on a straight line by the distances in N1804, with the feeds in N1805 (0: at rapid). INFERRED: if the feeds differ, no
/// axis exceeds its own feed; if no axis has a feed, the motion is at rapid.
Status withdraw(Emitter& m) {
  const auto& store = macro_b_of(m).parameters;
  if (!nct_of(m).state.gear.on) return {};
  Axes to = m.position.machine;
  AxisMask named = 0;
  double minutes = 0, squares = 0;
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    const double travel = store.value(store.named("1804"), m.def.axis_numbers[a]),
                 feed = store.value(store.named("1805"), m.def.axis_numbers[a]);
    if (travel == 0) continue;
    to[a] += travel;
    named |= AxisMask{1} << a;
    squares += travel * travel;
    if (feed > 0) minutes = std::max(minutes, std::fabs(travel) / feed);
  }
  if (named == 0) return {};
  if (minutes == 0) return m.to_machine(MotionKind::rapid, to, named, 0);
  return m.to_machine(MotionKind::feed, to, named, std::sqrt(squares) / minutes);
}

void disengage(Emitter& m) {
  if (!nct_of(m).state.gear.on) return;
  nct_of(m).state.gear = {};
  m.emit(Uncouple{macro_b_of(m).parameters.text(macro_b_of(m).parameters.named("1802"))});
}

}  // namespace nct
}  // namespace kadr
