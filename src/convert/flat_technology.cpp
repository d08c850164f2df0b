// Spindle, tool, dwells and M functions of a flat program. For convert/flat_program; tested by tests/convert.

#include <algorithm>

#include "convert/source_setup.h"
#include "out/program/words.h"

namespace kadr {
namespace {

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
    if (speed.surface) KADR_TRY(blocks_.code({{Function::surface_speed, any_argument}, {Function::css_on, any_argument}, {Function::surface_speed_limited, 0}}));
    else KADR_TRY(blocks_.code({{Function::spindle_rpm, any_argument}, {Function::css_off, any_argument}, {Function::surface_speed_limited, 1}}));
    surface_ = speed.surface;
  }
  rpm_ = speed.value;
  KADR_TRY(blocks_.word('S', speed.value));
  wants_direction_ = blocks_.def().behaviour.speed_needs_direction;
  return {};
}

Status FlatProgram::coolant(Coolant what) {
  constexpr Function by[] = {Function::coolant_off, Function::coolant_mist, Function::coolant_flood};
  return blocks_.code({{by[std::size_t(what)], any_argument}});
}

/// A control that has no table of tools, but a code that says a length (spec/grbl 4.15).
bool FlatProgram::is_length_by_word() const {
  const auto has = [&](std::initializer_list<Wanted> wanted) { return row_that_does(blocks_.def(), wanted) != nullptr; };
  return has({{Function::length_by_word, any_argument}}) && !has({{Function::length_plus, any_argument}, {Function::length_comp, 1}, {Function::tool_length, 0}});
}

Status FlatProgram::length_by_word(const OffsetsInForce& now) {
  if (way_ == FlatWay::plain || !is_length_by_word()) return {};
  const auto z = std::find(axes_.begin(), axes_.end(), "Z");
  const double length = now.length_sign == 0 || z == axes_.end() ? 0 : placement_.length[std::size_t(z - axes_.begin())];
  if (length == said_length_) return {};
  said_length_ = length;
  KADR_TRY(end_block());
  if (length == 0) KADR_TRY(blocks_.code({{Function::length_by_word_off, any_argument}, {Function::length_off, any_argument}}));
  else {
    KADR_TRY(blocks_.code({{Function::length_by_word, any_argument}}));
    KADR_TRY(blocks_.word('Z', length));
  }
  return blocks_.end();
}

/// With the spindle stopped.
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
  const bool together = blocks_.def().behaviour.tool_and_corrector;
  if (!change || number != selected_) {
    if (!blocks_.has_word('T')) return not_there("tool_word");
    KADR_TRY(blocks_.word('T', together ? number * corrector_digits + (corrector != 0 ? corrector : number) : number));
    selected_ = number;
  }
  if (change) KADR_TRY(blocks_.code({{Function::change_tool, any_argument}, {Function::exchange_tool, any_argument}, {Function::load_tool, any_argument}}));
  if (!change) return {};
  KADR_TRY(end_block());
  KADR_TRY(spindle_on());  // some controls stop it with the change
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

/// M codes go through under their number where the other control hands that number to its machine too.
Status FlatProgram::machine_code(std::uint32_t code) {
  const ControlDef& def = blocks_.def();
  const std::int32_t row = def.row_of('M', std::int32_t(10 * code));
  if (row < 0 || def.codes[std::size_t(row)].function != Function::machine_function) return not_there(("M" + std::to_string(code)).c_str());
  KADR_TRY(end_block());
  blocks_.text(with_digits(def, def.codes[std::size_t(row)]));
  return end_block();
}

}  // namespace kadr
