// Spindle, tool, dwells and M functions of a flat program. For convert/flat_program; tested by tests/convert.

#include "convert/flat_program.h"
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

Status FlatProgram::tool(std::uint32_t number, std::uint32_t corrector, bool change) {
  constexpr std::uint32_t corrector_digits = 100;
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
