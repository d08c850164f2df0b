// Modes and small functions: polar data, smoothing, dwell, feed control, threads, auxiliary functions (spec/nct/04, 05, 06, 08, 13.2).

#include <cmath>

#include "control/fanuc/fanuc.h"
#include "control/fanuc/geometry/sides.h"
#include "control/fanuc/lathe/lathe_words.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"

namespace kadr::functions {

/// G16 (5.4): switches polar data on. The program must then give radius and angle again.
Status polar_data_on(Emitter& m, const Call&) {
  if (!m.modal.polar_data) m.modal.polar_radius_given = m.modal.polar_angle_given = false;
  m.modal.polar_data = true;
  return {};
}

/// Executes codes that concern only the machine or the planner, so there is no action to emit.
Status no_action(Emitter&, const Call&) { return {}; }

/// G08 P1, P0 (spec/fanuc 11): switches look-ahead on or off. Look-ahead concerns only the machine, so P is checked and no action is
/// emitted.
Status look_ahead(Emitter& m, const Call& call) {
  if (m.has('P') && (m.value('P') == 0 || m.value('P') == 1)) return {};
  return fail(alarm(AlarmId::look_ahead_wrong, m.has('P') ? m.where('P') : call.where, call.row->code));
}

/// Executes M29 S (spec/fanuc 10.4): until G80, G84 and G74 tap rigidly, with the spindle synchronised with the drilling axis.
Status rigid_tapping(Emitter& m, const Call&) {
  fanuc_of(m).state.rigid_tap = true;
  return {};
}

Status polar_data_off(Emitter& m, const Call&) {
  m.modal.polar_data = false;
  return {};
}

/// G5.1 Q (4.7): stores the smoothing mode for the room `motion`, which does the smoothing. Axis words name the axes to smooth; nothing
/// moves. INFERRED: a motion of axes that were not named, or of a rotary axis, is not smoothed.
Status smoothing(Emitter& m, const Call& call) {
  if (!m.has('Q')) return fail(alarm(AlarmId::word_missing, call.where, 'Q', call.row->code));
  const auto q = m.whole('Q', 0, 3);
  if (!q) return fail(q.error());
  if (*q >= 2 && m.modal.feed_mode != FeedMode::per_minute) return fail(alarm(AlarmId::not_together, call.where, call.row->code, "G95"));
  m.modal.smoothing = static_cast<std::uint8_t>(*q);
  fanuc_of(m).state.smoothed = 0;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const char letter = m.block->words[i].address;
    if (letter != 0 && (m.letters.axes & letter_bit(letter)) != 0) fanuc_of(m).state.smoothed |= AxisMask{1} << m.def.address(letter).axis;
  }
  return {};
}

/// G4 P (8): dwells P seconds, or in G95 P revolutions of the main spindle.
Status dwell_or_turns(Emitter& m, const Call& call) {
  // spec/fanuc 4.1: on this control the decimal point decides the unit of the dwell time
  if (m.def.behaviour.dwell_unit != DwellUnit::seconds) {
    const bool by_point = m.def.behaviour.dwell_unit == DwellUnit::milliseconds_without_point;
    const char letter = m.has('P') || by_point ? 'P' : m.has('X') ? 'X' : 'U';
    if (!m.has(letter) && by_point) return fail(alarm(AlarmId::dwell_missing, call.where, call.row->code));
    if (!m.has(letter)) {
      m.block_exact = true;
      return {};
    }
    const auto seconds = letter == 'P' ? fanuc::dwell_by_digits(m) : Result<double>(m.value(letter));
    if (!seconds) return fail(seconds.error());
    if (!(*seconds >= 0)) return fail(alarm(AlarmId::value_out_of_range, m.where(letter), letter, *seconds));
    m.emit(Dwell{*seconds});
    return {};
  }
  if (!m.has('P')) return fail(alarm(AlarmId::word_missing, call.where, 'P', call.row->code));
  const auto seconds = fanuc::dwell_seconds(m, m.value('P'), m.where('P'));
  if (!seconds) return fail(seconds.error());
  m.emit(Dwell{*seconds});
  return {};
}

/// G62, G63, G64: stores the mode of feed control; the room `motion` applies the mode to the feed.
Status feed_control(Emitter& m, const Call&) {
  m.modal.exact = false;
  m.modal.blend_tolerance = 0;
  return {};
}

/// Executes G50.2, which ends polygon turning. Kadr never starts polygon turning, so there is nothing to end.
Status transform_off(Emitter&, const Call&) { return {}; }

/// G33 (4.4), on lathes G32, and G34, whose K changes the lead (spec/fanuc-t 8.1, 8.2): cuts a thread along one or two axes. F is the
/// thread lead in mm; or E is the number of threads per inch. Q is the start angle.
Status thread(Emitter& m, const Call& call) {
  if (call.row->modal) {
    m.modal.motion_row = static_cast<std::int16_t>(call.row - m.def.codes.data());
    m.modal.motion = MotionMode::linear;
  }
  if (m.has('F') && m.has('E')) return fail(alarm(AlarmId::thread_definition, call.where));
  for (const char letter : {'F', 'E'})
    if (m.has(letter) && !(m.value(letter) > 0)) return fail(alarm(AlarmId::thread_definition, m.where(letter)));
  KADR_TRY(fanuc::check_thread_words(m, call));
  AxisMask named = 0;
  Axes to;
  KADR_TRY(m.target(to, named));
  const double lead = fanuc::take_lead(m);
  if (named == 0) return {};
  if (!(lead > 0)) return fail(alarm(AlarmId::thread_definition, call.where));
  if (const int count = __builtin_popcount(named); count > 2) return fail(alarm(AlarmId::thread_axes, call.where, double(count)));
  const bool first = !fanuc_of(m).state.in_thread, lathe = m.def.behaviour.lathe != Lathe::none;
  if (lathe) fanuc::suspend_side(m);
  const auto mean_lead = call.row->arg == 34 ? fanuc::mean_lead(m, lead, to, named) : Result<double>(lead);
  if (!mean_lead) return fail(mean_lead.error());
  KADR_TRY(m.straight(MotionKind::thread, to, named));
  Motion& motion = std::get<Motion>(m.batch->back().what);
  motion.own_override = motion.no_hold = true;
  motion.unit = FeedUnit::mm_per_rev;
  motion.feed = *mean_lead;
  MotionDetail& detail = fanuc::detail_of(m, motion);
  detail.lead = lead;
  if (first) detail.start_angle = lathe ? fanuc::start_angle_of(m) : m.value('Q');
  fanuc_of(m).state.in_thread = true;
  return {};
}

/// Executes A, B, C, U, V, W as auxiliary functions (13.2).
Status auxiliary_word(Emitter& m, const Call& call) {
  const std::uint8_t number = m.def.address(call.word->address).number;
  macro_b_of(m).state.words.aux[number - 1u] = call.word->value;
  m.emit(AuxiliaryFunction{call.word->address, call.word->value});
  return {};
}

/// G10: changes tables; L selects the table (10.2.4, 10.2.5, 15.2, 24.1, 12.4).
Status set_tables(Emitter& m, const Call& call) { return fanuc::set_tables(m, call); }
Status set_tables_end(Emitter&, const Call&) { return {}; }

}  // namespace kadr::functions

namespace kadr::fanuc {

/// Returns the thread lead in mm. F is modal and is both the thread lead and the feed. E sets the thread lead only, not the feed; this lead
/// is valid until the next F (4.4, as spec/nct/04 recommends).
double take_lead(BlockContext& m) {
  if (m.has('E')) fanuc_of(m).state.thread_lead = mm_per_inch / m.value('E');
  else if (m.has('F')) fanuc_of(m).state.thread_lead = 0, m.modal.feed = m.length_value('F'), m.modal.feed_known = true;
  if (fanuc_of(m).state.thread_lead > 0) return fanuc_of(m).state.thread_lead;
  return m.modal.feed_known ? m.modal.feed : 0;
}

Result<double> dwell_by_digits(BlockContext& m) {
  const Word& p = *m.word('P');
  const bool by_point = m.def.behaviour.dwell_unit == DwellUnit::milliseconds_without_point;
  if (by_point && (p.has_point || p.expression)) return p.value;
  if (p.has_point) return fail(alarm(AlarmId::point_not_allowed, p.where, 'P'));
  constexpr double ms_per_s = 1000;
  return p.value / ms_per_s;
}

Result<double> dwell_seconds(Emitter& m, double p, Span where) {
  if (!(p >= 0)) return fail(alarm(AlarmId::value_out_of_range, where, 'P', p));
  if (m.modal.feed_mode != FeedMode::per_revolution || fanuc_of(m).settings.dwell_seconds) return p;
  const double rpm = fanuc_of(m).spindle_part > 0 ? fanuc_of(m).spindle_rpm(m) : 0;
  const std::string_view word = where.end > where.begin ? m.block->text_of(where) : "P";
  // a dwell in revolutions never ends while the spindle does not turn (8)
  if (!(rpm > 0)) return fail(alarm(AlarmId::spindle_not_turning, where, word));
  // INFERRED (8): a dwell in revolutions counts revolutions at the real spindle speed, which includes the override
  return p * 60 / (rpm * fanuc_of(m).spindle_part);
}

}  // namespace kadr::fanuc
