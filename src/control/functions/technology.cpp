// Functions for feed, spindle, tools, coolant, dwell, stops, and codes that go to the machine.

#include <cmath>
#include <optional>
#include <utility>

#include "control/functions/cutter_compensation.h"
#include "control/functions/functions.h"

namespace kadr {
namespace {

bool turns_spindle(const BlockContext& m) {
  return m.has_code({Function::spindle_cw, Function::spindle_ccw, Function::spindle_cw_coolant, Function::spindle_ccw_coolant});
}

/// Returns true if the spindle code is for spindles other than the first one. In this case the dialect has executed the code.
Result<bool> is_for_others(Emitter& m, SpindleDir dir, Span where) { return m.dialect->turns_spindle(m, dir, where); }

Status turn_spindle(Emitter& m, SpindleDir dir, Span where) {
  const auto others = is_for_others(m, dir, where);
  if (!others) return fail(others.error());
  if (*others) return {};
  // S before M3, M4 comes into force with the spindle (2С42 6.4.3).
  if (dir != SpindleDir::orient && m.modal.rpm_waiting >= 0) m.modal.rpm = std::exchange(m.modal.rpm_waiting, -1);
  if (dir != SpindleDir::orient && m.modal.rpm == 0 && !m.has('S')) m.warn(warning(AlarmId::speed_missing, where));
  m.modal.spindle = dir;
  m.emit(Spindle{dir, m.modal.surface_speed ? m.surface_speed().rpm(m.position.work, m.modal.rpm) : m.modal.rpm});
  return {};
}

Status flood(Emitter& m) {
  m.modal.flood = true;
  m.emit(CoolantSwitch{Coolant::flood});
  return {};
}

/// Returns the feed or speed that F or S means. If the set-up has a table of codes, the number is a code in the table (spec/gost 3: `F28`),
/// and the result is -1 if the table lacks the code. Without a table the result is the number itself.
double coded(const std::map<std::int32_t, double>& table, double value) {
  if (table.empty()) return value;
  const auto found = table.find(static_cast<std::int32_t>(value));
  return found == table.end() ? -1 : found->second;
}

Status dwell_for(Emitter& m, char letter) {
  const double seconds = m.value(letter);
  if (!(seconds >= 0)) return fail(alarm(AlarmId::value_out_of_range, m.where(letter), letter, seconds));
  m.emit(Dwell{seconds});
  return {};
}

/// Sets the feed of the axis whose word is directly before F.
Status feed_of_axis(BlockContext& m, const Call& call, std::size_t axis, double feed) {
  const bool arc =
      m.has_code({Function::arc_cw, Function::arc_ccw}) ||
      (!m.has_code({Function::rapid, Function::linear}) && (m.modal.motion == MotionMode::arc_cw || m.modal.motion == MotionMode::arc_ccw));
  // INFERRED: on an arc, F after the word of one axis is not allowed, because a single axis has no feed of its own on an arc.
  if (arc) return fail(alarm(AlarmId::not_together, call.where, m.block->text_of(call.where), "G2, G3"));
  if (!(feed > 0)) return fail(alarm(AlarmId::value_out_of_range, call.where, 'F', feed));
  m.modal.axis_feed[axis] = feed;
  m.modal.feeds_of_axes |= 1u << axis;
  return {};
}

/// Checks that the block has no earlier F that is for all axes.
Status only_common_feed(const BlockContext& m, const Word& f) {
  for (std::uint32_t i = 0; &m.block->words[i] != &f; ++i)
    if (m.block->words[i].address == 'F' && !m.axis_of_feed(i)) return fail(alarm(AlarmId::address_twice, f.where, 'F'));
  return {};
}

bool has_feed_of_axis(const BlockContext& m) {
  for (std::uint32_t i = 0; i < m.block->word_count; ++i)
    if (m.block->words[i].address == 'F' && m.axis_of_feed(i)) return true;
  return false;
}

/// Sets the feed of the motion along its path.
Status common_feed(Emitter& m, Span where, double value) {
  const bool is_length = m.modal.feed_mode != FeedMode::inverse_time;
  double feed = coded(m.def.feed_codes, value);
  if (!(feed >= 0)) return fail(alarm(AlarmId::value_out_of_range, where, 'F', value));
  if (is_length) feed *= m.unit_scale();
  const double most = m.def.behaviour.feed_most;
  if (most > 0 && feed > most && m.modal.feed_mode == FeedMode::per_minute) m.warn(warning(AlarmId::feed_limited, where, feed, most));
  m.modal.feed = feed;
  m.modal.feed_known = true;
  m.dialect->note_feed(m);
  return {};
}

/// Executes F on a control where F may be the feed of one axis. Such a feed stays in force until the axis gets another feed, or until a
/// block has a single F for all axes.
Status gost_feed(Emitter& m, const Call& call) {
  const double value = call.word->value * m.def.address('F').scale;
  const auto index = static_cast<std::uint32_t>(call.word - m.block->words.data());
  if (const auto axis = m.axis_of_feed(index)) return feed_of_axis(m, call, *axis, coded(m.def.feed_codes, value));
  KADR_TRY(only_common_feed(m, *call.word));
  if (!has_feed_of_axis(m)) m.modal.feeds_of_axes = 0;
  return common_feed(m, call.where, value);
}

}  // namespace

namespace functions {

Status feed_word(Emitter& m, const Call& call) {
  if (m.def.behaviour.feed_of_axis && call.word != nullptr) return gost_feed(m, call);
  return common_feed(m, call.where, m.value('F'));
}

Status speed_word(Emitter& m, const Call& call) {
  const double rpm = coded(m.def.speed_codes, m.value('S'));
  if (!(rpm >= 0)) return fail(alarm(AlarmId::value_out_of_range, call.where, 'S', m.value('S')));
  if (m.def.behaviour.speed_needs_direction && !turns_spindle(m)) {  // S is stored until M3 or M4 starts the spindle (2С42 6.4.3)
    m.warn(warning(AlarmId::speed_without_direction, call.where));
    m.modal.rpm_waiting = rpm;
    return {};
  }
  m.modal.rpm = rpm;
  m.modal.rpm_waiting = -1;
  const SurfaceSpeed surface = m.surface_speed();
  if (!turns_spindle(m)) m.emit(Speed{rpm, surface.on, 1, 0, surface.on ? surface.rpm(m.position.work, rpm) : 0});
  if (surface.on) m.emit(surface);
  return {};
}

/// T: selects a tool, which is a pocket of the magazine. On a control where T also gives the offset number, T0404 is tool 04 with offset 04
/// (spec/gost 4).
Status tool_word(Emitter& m, const Call& call) {
  const auto number = m.whole('T', 0, 99'999'999);
  if (!number) return fail(number.error());
  constexpr std::uint32_t marked =
      // T112 of the 2С42 means tool 12; the 1 means that the tool is in the spindle. INFERRED: the digit 1 is an error if tool 12 is not in
      // the spindle.
      100;
  if (m.def.grammar.word('T').one_more && *number >= marked) {
    if (m.modal.tool != *number % marked) return fail(alarm(AlarmId::too_many_digits, call.where, 'T', 3.0, 2.0));
    m.modal.tool_selected = m.modal.tool;
    m.use.change_to(m.modal.tool);
    m.emit(ToolChange{m.modal.tool, {}, true});
    return {};
  }
  const bool pair = m.def.behaviour.tool_and_corrector && call.word->digits > 2;
  m.modal.tool_selected = pair ? *number / 100 : *number;
  m.modal.corrector = pair ? *number % 100 : 0;
  if (m.modal.tool_selected != 0) m.use.note(UseKind::tool, m.modal.tool_selected, m.origin);
  if (pair && m.modal.corrector < m.tables.offsets.size()) {
    m.modal.offset_number = m.modal.corrector;
    m.change_frames();
  }
  m.emit(ToolSelect{m.modal.tool_selected, m.modal.corrector});
  return {};
}

Status change_tool(Emitter& m, const Call&) {
  m.modal.tool = m.modal.tool_selected;
  m.use.change_to(m.modal.tool);
  m.emit(ToolChange{m.modal.tool});
  return {};
}

Status spindle_cw(Emitter& m, const Call& call) { return turn_spindle(m, SpindleDir::cw, call.where); }
Status spindle_ccw(Emitter& m, const Call& call) { return turn_spindle(m, SpindleDir::ccw, call.where); }
Status spindle_orient(Emitter& m, const Call& call) { return turn_spindle(m, SpindleDir::orient, call.where); }
Status spindle_stop(Emitter& m, const Call& call) {
  const auto others = is_for_others(m, SpindleDir::stop, call.where);
  if (!others) return fail(others.error());
  if (*others) return {};
  m.modal.spindle = SpindleDir::stop;
  m.emit(Spindle{SpindleDir::stop, 0});
  return {};
}
Status spindle_cw_coolant(Emitter& m, const Call& call) {
  KADR_TRY(turn_spindle(m, SpindleDir::cw, call.where));
  return flood(m);
}
Status spindle_ccw_coolant(Emitter& m, const Call& call) {
  KADR_TRY(turn_spindle(m, SpindleDir::ccw, call.where));
  return flood(m);
}

Status coolant_mist(Emitter& m, const Call&) {
  m.modal.mist = true;
  m.emit(CoolantSwitch{Coolant::mist});
  return {};
}
Status coolant_flood(Emitter& m, const Call&) { return flood(m); }
Status coolant_off(Emitter& m, const Call&) {
  m.modal.mist = m.modal.flood = false;
  m.emit(CoolantSwitch{Coolant::off});
  return {};
}

/// Executes G4. Its row in the control's table names the word with the time: E in 0.1 s (2С42), P in s.
Status dwell(Emitter& m, const Call& call) {
  for (char letter = 'A'; letter <= 'Z'; ++letter)
    if ((call.row->takes & letter_bit(letter)) != 0 && m.has(letter)) return dwell_for(m, letter);
  return fail(alarm(AlarmId::word_missing, call.where, 'P', call.row->code));
}

/// Executes a dwell word in a block with a motion. The dwell begins when the motion has ended (2С42 6.4.5).
Status dwell_word(Emitter& m, const Call& call) { return dwell_for(m, call.word->address); }

Status machine_function(Interpreter& m, const Call& call) { return m.dialect->machine_code(m, call); }

Status program_stop(Emitter& m, const Call&) {
  stop_off_contour(m);
  m.emit(Stop{false});
  return {};
}

/// M01: stops only while the operator's switch for the optional stop is on.
Status optional_stop(Emitter& m, const Call& call) {
  stop_off_contour(m);
  m.use.note(UseKind::optional_stop, 1, m.origin);
  // On a control with arg 1 in the row of M01, the stop is emitted whatever the switch, because the machine's logic reads the switch
  // itself.
  const bool always_reported = call.row->arg == 1;
  if (m.optional_stop_on || always_reported) m.emit(Stop{true});
  return {};
}

}  // namespace functions

Status Emitter::emit_machine_function(const Call& call) {
  MachineFunction function{static_cast<std::uint32_t>(call.word->code / 10), {}, {}};
  if ((call.row->takes & letter_bit('P')) != 0 && has('P')) function.p = value('P');
  if ((call.row->takes & letter_bit('Q')) != 0 && has('Q')) function.q = value('Q');
  emit(function);
  return {};
}

}  // namespace kadr
