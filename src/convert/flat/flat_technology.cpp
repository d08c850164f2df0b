// Writes the spindle, tool, dwells and M functions of a flat program. Used by convert/flat/flat_program; tested by tests/convert.

#include <algorithm>

#include "config/machine/machine_codes.h"
#include "convert/code_match.h"
#include "convert/source_setup.h"
#include "out/program/words.h"

namespace kadr {
namespace {

constexpr std::initializer_list<FunctionArg> continuous_path_codes = {{Function::constant_velocity, any_argument},
                                                                      {Function::feed_control, continuous_cutting}};

Status not_there(const char* what) { return fail(alarm(AlarmId::function_has_no_code, {}, std::string_view(what))); }

}  // namespace

Status FlatProgram::spindle(const Spindle& spindle) {
  if (spindle.number != 1) return not_there("spindle_axis_word");
  const bool turns = spindle.dir == SpindleDir::cw || spindle.dir == SpindleDir::ccw;
  if (turns && !surface_ && spindle.rpm > 0 && spindle.rpm != rpm_) KADR_TRY(blocks_.word('S', rpm_ = spindle.rpm));
  turns_ = spindle.dir;
  wants_direction_ = false;
  switch (spindle.dir) {
    case SpindleDir::cw:
    case SpindleDir::ccw: KADR_TRY(spindle_on()); break;
    case SpindleDir::stop: KADR_TRY(blocks_.code({{Function::spindle_stop, any_argument}, {Function::spindle_code, 5}})); break;
    case SpindleDir::orient: KADR_TRY(blocks_.code({{Function::spindle_orient, any_argument}, {Function::spindle_code, 19}})); break;
    case SpindleDir::position: return not_there("spindle_orient");
  }
  return end_block();
}

Status FlatProgram::spindle_on() {
  if (turns_ == SpindleDir::cw) return blocks_.code({{Function::spindle_cw, any_argument}, {Function::spindle_code, 3}});
  if (turns_ == SpindleDir::ccw) return blocks_.code({{Function::spindle_ccw, any_argument}, {Function::spindle_code, 4}});
  return {};
}

Status FlatProgram::speed(const Speed& speed) {
  if (speed.number != 1) return not_there("spindle_word");
  if (speed.surface != surface_) {
    if (speed.surface)
      KADR_TRY(
          blocks_.code({{Function::surface_speed, any_argument}, {Function::css_on, any_argument}, {Function::surface_speed_limited, 0}}));
    else KADR_TRY(constant_speed());
    surface_ = speed.surface;
  }
  rpm_ = speed.value;
  KADR_TRY(blocks_.word('S', speed.value));
  wants_direction_ = blocks_.def().behaviour.speed_needs_direction;
  return {};
}

/// Writes G97, which ends the constant surface speed.
Status FlatProgram::constant_speed() {
  return blocks_.code({{Function::spindle_rpm, any_argument}, {Function::css_off, any_argument}, {Function::surface_speed_limited, 1}});
}

Status FlatProgram::coolant(Coolant what) {
  constexpr Function by[] = {Function::coolant_off, Function::coolant_mist, Function::coolant_flood};
  if (const auto code = source_.coolants[std::size_t(what)]) {
    blocks_.text(machine_code_text(blocks_.def(), *code));
    return {};
  }
  return blocks_.code({{by[std::size_t(what)], any_argument}});
}

/// True for a control without a tool table, whose length code contains the length itself as a word (spec/grbl 4.15).
bool FlatProgram::is_length_by_word() const {
  const auto has = [&](std::initializer_list<FunctionArg> functions) { return row_that_does(blocks_.def(), functions) != nullptr; };
  return has({{Function::length_by_word, any_argument}}) &&
         !has({{Function::length_plus, any_argument}, {Function::length_comp, 1}, {Function::tool_length, 0}});
}

Status FlatProgram::length_by_word(const OffsetsInForce& now) {
  if (form_ == FlatForm::plain || !is_length_by_word()) return {};
  const auto z = std::find(axes_.begin(), axes_.end(), "Z");
  const double length = now.length_sign == 0 || z == axes_.end() ? 0 : placement_.length[std::size_t(z - axes_.begin())];
  if (length == written_length_) return {};
  written_length_ = length;
  KADR_TRY(end_block());
  if (length == 0) KADR_TRY(blocks_.code({{Function::length_by_word_off, any_argument}, {Function::length_off, any_argument}}));
  else {
    KADR_TRY(blocks_.code({{Function::length_by_word, any_argument}}));
    KADR_TRY(blocks_.word('Z', length));
  }
  return blocks_.end();
}

/// Writes a stop for a tool change by hand, with the spindle stopped.
Status FlatProgram::tool_by_hand(std::uint32_t number) {
  KADR_TRY(end_block());
  const SpindleDir turned = turns_;
  if (turned == SpindleDir::cw || turned == SpindleDir::ccw) KADR_TRY(blocks_.code({{Function::spindle_stop, any_argument}}));
  if (coolant_ != Coolant::off) KADR_TRY(coolant(Coolant::off));
  KADR_TRY(blocks_.end());
  KADR_TRY(blocks_.code({{Function::program_stop, any_argument}}));
  blocks_.comment("T" + std::to_string(number));
  KADR_TRY(blocks_.end());
  selected_ = number;
  KADR_TRY(spindle_on());
  if (coolant_ != Coolant::off) KADR_TRY(coolant(coolant_));
  return blocks_.end();
}

Status FlatProgram::tool(std::uint32_t number, std::uint32_t corrector, bool change) {
  constexpr std::uint32_t corrector_digits = 100;
  if (change && !changes_tools(blocks_.def())) return tool_by_hand(number);
  if (has_turret()) return {};  // a turret turns at the change itself, see turret()
  const bool together = blocks_.def().behaviour.tool_and_corrector;
  if (!change || number != selected_) {
    if (!blocks_.has_word('T')) return not_there("tool_word");
    KADR_TRY(blocks_.word('T', together ? number * corrector_digits + (corrector != 0 ? corrector : number) : number));
    selected_ = number;
  }
  if (change)
    KADR_TRY(blocks_.code(
        {{Function::change_tool, any_argument}, {Function::exchange_tool, any_argument}, {Function::load_tool, any_argument}}));
  if (!change) return {};
  KADR_TRY(end_block());
  KADR_TRY(spindle_on());  // restarts the spindle, because some controls stop it at the tool change
  return end_block();
}

Status FlatProgram::dwell(double seconds) {
  const CodeRow* const row = row_that_does(blocks_.def(), {{Function::dwell, any_argument}, {Function::dwell_or_turns, any_argument}});
  if (row == nullptr) return not_there("dwell");
  KADR_TRY(end_block());
  blocks_.text(with_digits(blocks_.def(), *row));
  KADR_TRY(blocks_.dwell_word(*row, seconds));
  return end_block();
}

/// Writes the code of the feed unit. A control without such codes always uses mm/min.
Status FlatProgram::feed_unit(FeedUnit unit) {
  if (unit_ == unit) return {};
  constexpr Function by[] = {Function::feed_per_minute, Function::feed_per_revolution, Function::feed_inverse_time};
  const auto has = [&](Function function) { return row_that_does(blocks_.def(), {{function, any_argument}}) != nullptr; };
  const bool is_one = !has(by[1]) && !has(by[2]), is_usual = unit == FeedUnit::mm_per_min && (is_one || (!unit_ && !has(by[0])));
  unit_ = unit;
  feed_ = -1;
  if (is_usual) return {};
  return blocks_.code({{by[std::size_t(unit)], any_argument}});
}

/// Writes the feed. If the target control cannot express a feed per revolution, or its format would round it to 0, the feed becomes a feed
/// per minute at the spindle speed in force.
Status FlatProgram::feed(const Motion& motion) {
  FeedUnit unit = source_unit_ = motion.unit;
  double feed = motion.feed;
  const bool is_at_speed = (turns_ == SpindleDir::cw || turns_ == SpindleDir::ccw) && !surface_ && rpm_ > 0;
  if (unit == FeedUnit::mm_per_rev && is_at_speed) {
    const bool has_code = row_that_does(blocks_.def(), {{Function::feed_per_revolution, any_argument}}) != nullptr;
    if (!has_code || Words(blocks_.def(), 'F').rounded(feed) == 0) unit = FeedUnit::mm_per_min, feed *= rpm_;
  }
  KADR_TRY(feed_unit(unit));
  if (feed == feed_ && unit != FeedUnit::per_min) return {};
  feed_ = feed;
  return blocks_.word('F', feed);
}

/// True if the control has codes that switch exact stop mode on and off.
bool FlatProgram::has_stop_modes() const {
  const ControlDef& def = blocks_.def();
  return row_that_does(def, {{Function::exact_stop_mode, any_argument}}) != nullptr && row_that_does(def, continuous_path_codes) != nullptr;
}

Status FlatProgram::stop_mode(bool exact) {
  is_exact_ = exact;
  tolerance_ = 0;
  corners_ = CornerSpeed::limited;
  return exact ? blocks_.code({{Function::exact_stop_mode, any_argument}}) : blocks_.code(continuous_path_codes);
}

/// Writes, in the block of the motion, whether the axes stop exactly at its end. Without a code for exact stops, the target control does
/// not stop there; the conversion reports this difference (convert/conversion).
Status FlatProgram::end_of_motion(bool exact) {
  if (exact == is_exact_) return {};
  const bool has_modes = has_stop_modes();
  if (exact && (is_between() || !has_modes) && blocks_.code_if_there({{Function::exact_stop_block, any_argument}})) return {};
  return has_modes ? stop_mode(exact) : Status();
}

/// Writes the path tolerance G64 P if the control has it.
Status FlatProgram::rounding(const Motion& motion) {
  if (motion.exact || motion.tolerance == tolerance_) return {};
  tolerance_ = motion.tolerance;
  if (!modes_.tolerance) return {};
  is_exact_ = false;
  KADR_TRY(blocks_.code({{Function::constant_velocity, any_argument}}));
  // number of decimals that P has in addition to those of the control, down to 0.000001 mm, if the control allows any number of decimals
  constexpr int more = 3;
  return tolerance_ > 0 ? blocks_.word('P', tolerance_, more) : Status();
}

/// Writes the corner mode in the block of the motion: G62, G63 or the code that ends them.
Status FlatProgram::corners(const Motion& motion) {
  if (motion.corner_speed == corners_ || !modes_.speeds) return {};
  // true: the code of the exact stop mode replaces the corner mode, so no corner mode is written
  const bool exact_by_mode = motion.exact && !is_between() && has_stop_modes();
  return exact_by_mode ? Status() : corner_mode(motion.corner_speed);
}

Status FlatProgram::corner_mode(CornerSpeed corners) {
  constexpr int by[] = {continuous_cutting, inner_corners, without_slowing};
  corners_ = corners;
  is_exact_ = false;
  return blocks_.code({{Function::feed_control, by[std::size_t(corners)]}});
}

/// Writes G5.1 before the block of the motion. Q1 joins short motions. Only straight motions can be smoothed (nct 4.7).
Status FlatProgram::smoothing(const Motion& motion) {
  if (motion.kind != MotionKind::feed || motion.exact || !modes_.smoothing) return {};
  const std::uint8_t mode = motion.smoothing != 0 ? motion.smoothing : std::uint8_t(motion.join != 0 ? 1 : 0);
  return mode == smoothing_ ? Status() : smoothing_mode(mode);
}

Status FlatProgram::smoothing_mode(std::uint8_t smoothing) {
  KADR_TRY(end_block());
  smoothing_ = smoothing;
  KADR_TRY(blocks_.code({{Function::smoothing, any_argument}}));
  KADR_TRY(blocks_.word('Q', smoothing));
  return blocks_.end();
}

/// Writes an M code. Its number is mapped by the tables of both controls. Without a table row, the number stays unchanged if the target
/// control also passes it to its machine.
Status FlatProgram::machine_code(std::uint32_t code) {
  const ControlDef& def = blocks_.def();
  const auto mapped = source_.machine_codes.find(code);
  const std::uint32_t there = mapped != source_.machine_codes.end() ? mapped->second : code;
  const bool is_taken = mapped == source_.machine_codes.end() && std::any_of(source_.machine_codes.begin(), source_.machine_codes.end(),
                                                                             [&](const auto& one) { return one.second == code; });
  const CodeRow* const row = machine_row(def, there);
  if (is_taken || row == nullptr || (mapped == source_.machine_codes.end() && row->function != Function::machine_function))
    return not_there(("M" + std::to_string(code)).c_str());
  KADR_TRY(end_block());
  blocks_.text(machine_code_text(def, there));
  return end_block();
}

Status FlatProgram::stop(const Stop& stop) {
  if (stop.reason == StopReason::single_block || (stop.reason == StopReason::message && source_.same_messages)) return {};
  KADR_TRY(end_block());
  KADR_TRY(blocks_.code({{stop.optional ? Function::optional_stop : Function::program_stop, any_argument}}));
  return blocks_.end();
}

Status FlatProgram::message(const Message& message) {
  if (source_.same_messages || message.asks) return no_code("message");
  KADR_TRY(end_block());
  blocks_.comment(message.text);
  return blocks_.end();
}

}  // namespace kadr
