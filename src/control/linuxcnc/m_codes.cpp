// M codes: tools, outputs and inputs, orientation, saved and restored modes; G7, G8 (spec/linuxcnc 8; convert_m of LinuxCNC's source).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/units.h"
#include "control/functions/functions.h"
#include "control/interpreter.h"
#include "control/linuxcnc/linuxcnc.h"
#include "control/linuxcnc/o_line_flow.h"
#include "control/linuxcnc/spindles.h"

namespace kadr::linuxcnc {
namespace {

Status compensation_forbids(const BlockContext& m, Span where, const char* text) {
  if (m.modal.radius_side == 0) return {};
  return linuxcnc_of(m).fault(AlarmId::rs274_compensation, where, text);
}

tl::unexpected<Alarm> wrong_word(const BlockContext& m, Span where, std::string text) {
  return linuxcnc_of(m).fault(AlarmId::rs274_io, where, std::move(text));
}

}  // namespace

namespace {

/// Restores the coolant by M7, M8 or M9, but only if mist or flood changes (write_m_codes, gen_m_codes). While both are on, one of them
/// alone cannot be switched off. `mist`, `flood`: the present state.
void restore_coolant(Emitter& m, bool mist, bool flood) {
  Modal& modal = m.modal;
  if (!modal.mist && !modal.flood) {
    if (mist || flood) m.emit(CoolantSwitch{Coolant::off});
    return;
  }
  if (modal.mist && !mist) m.emit(CoolantSwitch{Coolant::mist});
  if (modal.flood && !flood) m.emit(CoolantSwitch{Coolant::flood});
  modal.mist = modal.mist || mist;
  modal.flood = modal.flood || flood;
}

/// Restores saved modes (spec/linuxcnc 8): puts the codes of the modal groups in force, and emits an action for each change. LinuxCNC
/// executes a block of codes instead; in this block F has one decimal and S has none.
Status restore_modes(Interpreter& m, const Modal& to) {
  Modal& modal = m.modal;
  const Modal before = modal;
  m.modes_changed();
  const bool spindle_changes = modal.spindle != to.spindle, speed_changes = modal.rpm != to.rpm;
  const bool mist = modal.mist, flood = modal.flood;
  const MotionModal motion = modal;
  const std::uint32_t fixture = to.fixture;
  Modal next = to;
  static_cast<MotionModal&>(next) = motion;
  for (std::size_t g = 1; g < m.def.groups.size(); ++g)
    if (g != linuxcnc_of(m).groups.index_of_g(1)) next.rows[g] = to.rows[g];
  next.feed_known = to.feed_known;
  // LinuxCNC restores F by a block of codes in which F has only one decimal, so the feed is rounded in the same way
  next.feed = std::round(to.feed * 10) / 10;
  if (to.inch) next.feed = std::round(to.feed / mm_per_inch * 10) / 10 * mm_per_inch;
  next.tool = before.tool;
  next.tool_selected = before.tool_selected;
  next.motion = before.motion;
  next.motion_row = before.motion_row;
  next.contour = before.contour;
  next.rpm = std::round(to.rpm);
  modal = next;
  m.variables.inch = false;  // parameters are in the machine's unit, whatever the saved unit (spec/linuxcnc 1.1)
  if (speed_changes && !spindle_changes) m.emit(Speed{modal.rpm, modal.surface_speed});
  if (spindle_changes) m.emit(Spindle{modal.spindle, modal.spindle == SpindleDir::stop ? 0 : modal.rpm});
  restore_coolant(m, mist, flood);
  if (before.fixture != fixture) linuxcnc_of(m).take_system(m, fixture);
  return {};
}

}  // namespace

Status restore_at_end(Interpreter& m) {
  LinuxCnc& control = linuxcnc_of(m);
  std::optional<Modal> to;
  if (control.saved_modes.size() > 1) {
    for (const SavedModes& saved : control.saved_modes.back())
      if (saved.restore_at_end) to = saved.modal;
    control.saved_modes.pop_back();
  }
  return to ? restore_modes(m, *to) : Status();
}

}  // namespace kadr::linuxcnc

namespace kadr::linuxcnc {

/// Refuses M100 to M199. In LinuxCNC these codes start programs on the machine's computer; Kadr starts no programs.
Status LinuxCnc::machine_code(Interpreter&, const Call& call) {
  return fault(AlarmId::rs274_codes, call.where, fmt::format("Unknown m code used: M{}", call.word->code / 10));
}

}  // namespace kadr::linuxcnc

namespace kadr::functions {

using linuxcnc::linuxcnc_of;

namespace {

void emit_output(Emitter& m, int code, double number, std::optional<double> value) {
  MachineFunction function{static_cast<std::uint32_t>(code)};
  function.number = std::round(number);
  function.value = value;
  m.emit(function);
}

}  // namespace

/// T: selects the tool to be loaded next, which must be in the tool table.
Status tool_of_table(Emitter& m, const Call& call) {
  const double number = std::round(m.value('T'));
  if ((number != 0 || linuxcnc_of(m).machine.random_changer) && linuxcnc_of(m).tool(number) == nullptr)
    return linuxcnc_of(m).fault(AlarmId::rs274_tool, call.where, fmt::format("Requested tool {:.0f} not found in the tool table", number));
  m.modal.tool_selected = static_cast<std::uint32_t>(number);
  if (number != 0) m.use.note(UseKind::tool, m.modal.tool_selected, m.origin);
  m.emit(ToolSelect{m.modal.tool_selected, 0});
  return {};
}

/// M6: stops the spindle and loads the tool of the last T. If there was no T, M6 empties the spindle.
Status load_tool(Emitter& m, const Call& call) {
  KADR_TRY(linuxcnc::compensation_forbids(m, call.where, "Cannot change tools with cutter radius compensation on"));
  const bool turns = m.modal.spindle == SpindleDir::cw || m.modal.spindle == SpindleDir::ccw;
  if (!linuxcnc_of(m).machine.spindle_turns_in_change) {
    if (turns) m.emit(Spindle{SpindleDir::stop, 0});
    m.modal.spindle = SpindleDir::stop;
  }
  m.modal.tool = m.modal.tool_selected;
  m.use.change_to(m.modal.tool);
  m.emit(ToolChange{m.modal.tool});
  linuxcnc_of(m).retain_length(m);
  return {};
}

/// M61 Q: sets the number of the tool in the spindle, without a tool change.
Status tool_in_spindle(Emitter& m, const Call& call) {
  const double number = m.has('Q') ? std::round(m.value('Q')) : -1;
  if (number < 0) return linuxcnc_of(m).fault(AlarmId::rs274_tool, call.where, "Need non-negative Q-word to specify tool number with M61");
  if ((number != 0 || linuxcnc_of(m).machine.random_changer) && linuxcnc_of(m).tool(number) == nullptr)
    return linuxcnc_of(m).fault(AlarmId::rs274_tool, call.where, fmt::format("Requested tool {:.0f} not found in the tool table", number));
  m.modal.tool = static_cast<std::uint32_t>(number);
  m.emit(ToolChange{m.modal.tool});
  linuxcnc_of(m).retain_length(m);
  return {};
}

/// M62 to M65 P: switch a digital output on or off. arg: the number of the code.
Status digital_output(Emitter& m, const Call& call) {
  const int code = call.row->arg;
  const char* const forbidden = code == 62   ? "Cannot set motion output with cutter radius compensation on"
                                : code == 63 ? "Cannot set motion digital output with cutter radius compensation on"
                                             : "Cannot set auxiliary digital output with cutter radius compensation on";
  KADR_TRY(linuxcnc::compensation_forbids(m, call.where, forbidden));
  if (!m.has('P')) return linuxcnc::wrong_word(m, call.where, fmt::format("No valid P word with M{}", code));
  emit_output(m, code, m.value('P'), std::nullopt);
  return {};
}

/// M67, M68 E Q: set an analog output. arg: the number of the code.
Status analog_output(Emitter& m, const Call& call) {
  const int code = call.row->arg;
  KADR_TRY(linuxcnc::compensation_forbids(m, call.where,
                                          code == 67 ? "Cannot set motion analog output with cutter radius compensation on"
                                                     : "Cannot set auxiliary analog output with cutter radius compensation on"));
  if (!m.has('E') || std::round(m.value('E')) < 0)
    return linuxcnc::wrong_word(m, call.where, fmt::format("Invalid analog index with M{}", code));
  emit_output(m, code, m.value('E'), m.has('Q') ? m.value('Q') : -1);  // a missing Q has the value -1, as in LinuxCNC's source
  return {};
}

/// M66: waits for an input. Kadr does not know the state of the input, so #5399 becomes 0, or -1 for a wait that may time out (INFERRED).
Status wait_for_input(Emitter& m, const Call& call) {
  const double kind = m.has('L') ? std::round(m.value('L')) : 0;
  const bool digital = m.has('P'), analog = m.has('E');
  KADR_TRY(linuxcnc::compensation_forbids(m, call.where, "Cannot wait for digital input with cutter radius compensation on"));
  if (digital && analog) return linuxcnc::wrong_word(m, call.where, "Invalid to select both a digital and an analog input with M66");
  if (!digital && !analog) return linuxcnc::wrong_word(m, call.where, "Need to have either a valid P or a valid E word with M66");
  if (kind != 0 && !(m.has('Q') && m.value('Q') > 0))
    return linuxcnc::wrong_word(m, call.where, "Zero timeout with wait type != immediate return");
  if (analog && kind != 0) return linuxcnc::wrong_word(m, call.where, "Can't select analog input with wait type != immediate return");
  emit_output(m, 66, m.value(digital ? 'P' : 'E'), std::nullopt);
  constexpr std::uint32_t result = 5399;
  m.variables.set_raw(result, kind != 0 ? -1 : 0);
  (void)m.variables.consume_frames_changed();
  return {};
}

/// M19 R P Q: orients the spindle.
Status orient_to(Emitter& m, const Call& call) {
  linuxcnc::LinuxCnc& control = linuxcnc_of(m);
  const int before = control.state.active_spindle;
  control.state.active_spindle = 0;
  const Status chosen = linuxcnc::take_spindle(m, "Spindle ($) number out of range in M19 Command", call.where);
  const int number = std::exchange(control.state.active_spindle, before);
  KADR_TRY(chosen);
  m.modal.spindle = SpindleDir::stop;
  for (linuxcnc::OtherSpindle& other : control.state.others) other.dir = SpindleDir::stop;
  if (m.has('R') || m.has('P')) {
    Spindle spindle{SpindleDir::orient, 0, static_cast<std::uint8_t>(number + 1)};
    spindle.angle = (m.has('R') ? m.value('R') : 0) + control.machine.orient_offset;
    m.emit(spindle);
  }
  if (m.has('Q') && !(m.value('Q') > 0)) return linuxcnc::wrong_word(m, call.where, "Q word with M19 requires a value > 0");
  return {};
}

/// M50 to M53 P: switch the overrides on or off. In M51 the word `$` can only select a spindle other than the first one, because by mistake
/// LinuxCNC refuses the number of the first spindle.
Status override_switch(Emitter& m, const Call& call) {
  const bool on = !m.has('P') || m.value('P') != 0;
  KADR_TRY(linuxcnc::compensation_forbids(
      m, call.where,
      on ? "Cannot enable overrides with cutter radius compensation on" : "Cannot disable overrides with cutter radius compensation on"));
  const char spindle = linuxcnc_of(m).spindle_address;
  if (call.row->arg == 51 && m.has(spindle)) {
    const double number = m.value(spindle);
    if (!(number > 0 && number < linuxcnc_of(m).machine.spindles))
      return linuxcnc_of(m).fault(AlarmId::rs274_spindle, call.where, "Invalid spindle ($) number in M51 command");
    return {};
  }
  const std::uint8_t bit = call.row->arg == 50 ? feed_permission : call.row->arg == 51 ? 2 : 0;
  m.modal.override_permission = static_cast<std::uint8_t>(on ? m.modal.override_permission | bit : m.modal.override_permission & ~bit);
  return {};
}

/// M70 to M73: save and restore modes. arg: the number of the code.
Status modes_kept(Interpreter& m, const Call& call) {
  linuxcnc::LinuxCnc& control = linuxcnc_of(m);
  auto& saved = control.saved_modes.back();
  switch (call.row->arg) {
    case 70:
    case 73:
      m.journal.on_undo([&saved, before = saved] { saved = before; });
      saved.assign(1, {m.modal, call.row->arg == 73});
      return {};
    case 71:
      m.journal.on_undo([&saved, before = saved] { saved = before; });
      saved.clear();
      return {};
    default:
      if (saved.empty())
        return control.fault(AlarmId::rs274_codes, call.where, "Cannot restore context from invalid stack frame - missing M70/M73?");
      return linuxcnc::restore_modes(m, saved.back().modal);
  }
}

/// G7 (arg 1): the word X is a diameter. G8 (arg 0): the word X is a radius.
Status diameter_mode(Emitter& m, const Call& call) {
  m.modal.diameter = call.row->arg == 1 ? AxisMask{1} : AxisMask{0};
  return {};
}

}  // namespace kadr::functions
