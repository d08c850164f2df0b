// G31 and G37: a probe signal ends the motion and deletes the distance to go (spec/nct/21).

#include "control/fanuc/modes/measuring.h"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "control/fanuc/fanuc.h"
#include "control/fanuc/tables/table_variables.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"
#include "control/functions/probe_unstated.h"

namespace kadr {
namespace {

constexpr int max_inputs = 8;
constexpr int torque_input = 98;     // value of P in G31 P98, where a torque limit takes the place of a probe signal
constexpr double full_torque = 255;  // value of Q that means 100 % torque
constexpr double max_torque_word = 254;

/// A modal group, and the code of this group that must be in force for measuring.
struct Needed {
  std::string_view group;
  std::string_view code;
};
constexpr Needed no_radius{"7", "G40"};  // G31 needs G40 in force; G37 does not
constexpr std::array<Needed, 5> always_needed{{{"17", "G15"}, {"11", "G50"}, {"22", "G50.1"}, {"16", "G69"}, {"5", "G94"}}};

/// Returns the code in force of a modal group; empty if no code of the group is in force.
std::string_view code_of(const BlockContext& m, std::string_view group) {
  for (std::size_t g = 1; g < m.def.groups.size(); ++g)
    if (m.def.groups[g].name == group && m.modal.rows[g] >= 0) return m.def.codes[static_cast<std::size_t>(m.modal.rows[g])].code;
  return {};
}

Status needs(const BlockContext& m, const Call& call, const Needed& needed) {
  const std::string_view code = code_of(m, needed.group);
  if (code.empty() || code == needed.code) return {};
  // INFERRED: the alarm names the code in force, not the code that measuring needs
  return fail(alarm(AlarmId::probe_state, call.where, code));
}

/// Checks that G15, G50, G50.1, G69, G94 are in force, and that polar interpolation is off (21.1, 21.3, 4.5).
Status state_allows(const BlockContext& m, const Call& call) {
  if (m.modal.surface == PathSurface::polar) return fail(alarm(AlarmId::surface_state, call.where, call.row->code));
  // INFERRED: a lathe measures in every mode of its groups, whose numbers differ
  if (m.def.behaviour.lathe != Lathe::none) return {};
  for (const Needed& needed : always_needed) KADR_TRY(needs(m, call, needed));
  return {};
}

/// Reads P, the number of the probe input: 1 … 8, or 98 for the torque limit. Without P the number is 1.
Result<int> input_of(const BlockContext& m) {
  if (!m.has('P')) return 1;
  const auto p = m.whole('P', 1, torque_input);
  if (!p) return fail(p.error());
  if (*p > max_inputs && *p != torque_input) return fail(alarm(AlarmId::value_out_of_range, m.where('P'), 'P', double(*p)));
  return static_cast<int>(*p);
}

/// Checks N3019, which limits the following error of the axis during measuring (21.2). INFERRED: 0 means no limit; the following error is
/// the value in the set-up.
Status servo_follows(const BlockContext& m, const Call& call, AxisMask named) {
  const macro_b::ParameterStore& store = macro_b_of(m).parameters;
  const auto limit = store.named("3019");
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    const double most = store.value(limit, m.def.axis_numbers[a]);
    if ((named >> a & 1u) != 0 && most > 0 && fanuc_of(m).servo_lag[a] > most)
      return fail(alarm(AlarmId::probe_servo_error, call.where, std::string_view(m.axis_names[a])));
  }
  return {};
}

/// Checks that G31 P98 is possible (21.2): Q is from 1 to 254, and the block moves a single axis, whose drive reports its torque.
Status torque_possible(const BlockContext& m, const Call& call, AxisMask named) {
  if (!m.has('Q')) return fail(alarm(AlarmId::word_missing, call.where, 'Q', call.row->code));
  const double q = m.value('Q');
  if (!(q >= 1 && q <= max_torque_word)) return fail(alarm(AlarmId::probe_torque, m.where('Q'), q));
  int count = 0;
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if ((named >> a & 1u) != 0 && ++count == 2)
      return fail(alarm(AlarmId::probe_torque_axis, call.where, std::string_view(m.axis_names[a])));
  if (!fanuc_of(m).settings.torque_known) return fail(alarm(AlarmId::probe_torque_unknown, call.where));
  return servo_follows(m, call, named);
}

/// Returns the measuring feed, mm/min. If the parameter bit SKF (G31) or TLF (G37) is set, the parameter gives this feed; otherwise the
/// result is 0, which means the feed in force.
///   alarms  feed_missing
Result<double> measuring_feed(Emitter& m, bool by_parameter, double of_parameter, Span where) {
  if (!by_parameter) {
    KADR_TRY(m.feed_known(where));
    return 0;
  }
  // INFERRED: the control raises an alarm if the feed parameter is 0
  if (!(of_parameter > 0)) return fail(alarm(AlarmId::feed_missing, where));
  return of_parameter;
}

/// Adds the probe motion; the run then waits for the probe's answer.
///   feed  mm/min; 0: the feed in force
Status probe_motion(Emitter& m, const Axes& to, AxisMask named, double feed, int input) {
  KADR_TRY(m.straight(MotionKind::probe, to, named));
  Motion& motion = std::get<Motion>(m.batch->back().what);
  if (feed > 0) motion.feed = feed;
  MotionDetail& detail = fanuc::detail_of(m, motion);
  detail.input = input;
  if (input == torque_input) detail.torque = m.value('Q') / full_torque * 100;
  m.needs_probe = true;
  macro_b_of(m).stops_reading = true;
  return {};
}

/// Checks that N3004 and N3005 (21.3) are positive, and that N3004, the rapid distance, is greater than N3005. INFERRED: otherwise an alarm
/// reports the parameter as out of limits.
Status distances_fit(const BlockContext& m, const Call& call) {
  const fanuc::Settings& s = fanuc_of(m).settings;
  constexpr double rapid_distance = 3004, alarm_distance = 3005;
  if (!(s.length_alarm > 0)) return fail(alarm(AlarmId::value_out_of_range, call.where, 'N', alarm_distance));
  if (!(s.length_rapid > s.length_alarm)) return fail(alarm(AlarmId::value_out_of_range, call.where, 'N', rapid_distance));
  return {};
}

/// Returns the axis of the only axis word of G37. The axis must be linear, and the word must not be an increment. INFERRED: a second axis
/// word or a rotary axis raises the alarm for faulty data.
Result<std::size_t> length_axis(const BlockContext& m) {
  const Word* only = nullptr;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address == 0 || (m.letters.axes & letter_bit(w.address)) == 0) continue;
    const AddressRow& row = m.def.address(w.address);
    if (w.incremental || row.function == Function::increment_axis) return fail(alarm(AlarmId::increment_not_allowed, w.where, w.written));
    if (only != nullptr || (m.def.rotary >> row.axis & 1u) != 0)
      return fail(alarm(AlarmId::probe_torque_axis, w.where, std::string_view(m.axis_names[row.axis])));
    only = &w;
  }
  if (only == nullptr) return fail(alarm(AlarmId::no_axis_word, m.block->where, "G37"));
  return std::size_t{m.def.address(only->address).axis};
}

/// Computes the end point from the axis word of G37, which is absolute even in G91 (21.3).
Status absolute_target(BlockContext& m, Axes& to, AxisMask& named) {
  const bool absolute = std::exchange(m.modal.absolute, true);
  const Status read = m.target(to, named);
  m.modal.absolute = absolute;
  return read;
}

}  // namespace

namespace functions {

/// G31 (21.1): moves until a probe signal comes, and measures the position; with P98, until the torque limit is reached (21.2).
Status measure(Emitter& m, const Call& call) {
  KADR_TRY(state_allows(m, call));
  KADR_TRY(needs(m, call, no_radius));
  const auto input = input_of(m);
  if (!input) return fail(input.error());
  AxisMask named = 0;
  Axes to;
  KADR_TRY(m.target(to, named));
  if (*input == torque_input) KADR_TRY(torque_possible(m, call, named));
  const fanuc::Settings& s = fanuc_of(m).settings;
  const auto feed = measuring_feed(m, s.measure_parameter_feed, s.measure_feed, call.where);
  if (!feed) return fail(feed.error());
  fanuc_of(m).measurement = {};
  m.probe_where = call.where;
  return probe_motion(m, to, named, *feed, *input);
}

/// G37 (21.3): moves at rapid to the distance N3004 before the expected position, and then at feed until the signal comes, but at most to
/// the distance N3005 beyond the expected position.
Status measure_length(Emitter& m, const Call& call) {
  const fanuc::Settings& s = fanuc_of(m).settings;
  KADR_TRY(state_allows(m, call));
  if (m.modal.length_sign == 0 || m.modal.length_number == 0) return fail(alarm(AlarmId::word_missing, call.where, 'H', call.row->code));
  KADR_TRY(distances_fit(m, call));
  const auto axis = length_axis(m);
  if (!axis) return fail(axis.error());
  AxisMask named = 0;
  Axes to;
  KADR_TRY(absolute_target(m, to, named));
  const auto feed = measuring_feed(m, s.length_parameter_feed, s.length_feed, call.where);
  if (!feed) return fail(feed.error());
  const double expected = to[*axis];
  // INFERRED: the tool approaches the expected position from the side on which it is now
  const double side = m.position.programmed[*axis] < expected ? -1 : 1;
  to[*axis] = expected + side * s.length_rapid;
  KADR_TRY(m.straight(MotionKind::rapid, to, named));
  fanuc_of(m).measurement = {true, *axis, expected, s.length_alarm, m.modal.length_number};
  m.probe_where = call.where;
  to[*axis] = expected - side * s.length_alarm;
  return probe_motion(m, to, named, *feed, 1);  // INFERRED: G37 uses probe input 1
}

}  // namespace functions

namespace fanuc {
namespace {

/// Corrects the length offset that H selected by the difference q − Q: the expected position q less the position Q of the probe's signal.
/// Parameter bit TMW selects wear or geometry, TCA the sign. INFERRED: the new value takes effect with the next H.
Status correct_length(BlockContext& m, const Measurement& of, double there) {
  const double deviation = of.expected - there;
  if (!(std::fabs(deviation) <= of.window)) return fail(alarm(AlarmId::probe_window, m.probe_where, there, of.expected));
  m.journal.keep(m.tables.offsets[of.offset]);
  ToolOffset& offset = m.tables.offsets[of.offset];
  double& corrected = fanuc_of(m).settings.length_wear ? offset.length_wear : offset.length;
  // 5.3: for an axis in diameter programming the offset table has diameters
  const double entered = is_diameter(m, of.axis) ? 2 * deviation : deviation;
  corrected += fanuc_of(m).settings.length_adds ? entered : -entered;
  fanuc_of(m).changed_offsets.push_back(of.offset);
  return {};
}

}  // namespace

Status accept_answer(Emitter& m, const ProbeAnswer& answer) {
  Fanuc& fanuc = fanuc_of(m);
  fanuc.endless.note_change();
  m.needs_probe = false;
  for (std::size_t a = 0; a < m.axis_count; ++a) m.position.work[a] = answer.at[a];
  const Axes machine = m.frames.machine_of(m.position.work);
  for (std::size_t a = 0; a < m.axis_count; ++a) m.position.machine[a] = machine[a];
  m.position.programmed = m.transform.to_programmed(m.position.work);
  fanuc.probe_position = m.position.work;
  fanuc.probe_length = length_in_force(m);
  fanuc.probe_machine = m.position.machine;
  const Measurement measurement = std::exchange(fanuc.measurement, {});
  const bool touched = made_contact(m, answer);
  if (!measurement.length) return {};
  if (touched) return correct_length(m, measurement, m.position.work[measurement.axis]);
  return fail(alarm(AlarmId::probe_window, m.probe_where, m.position.work[measurement.axis], measurement.expected));  // INFERRED
}

}  // namespace fanuc
}  // namespace kadr
