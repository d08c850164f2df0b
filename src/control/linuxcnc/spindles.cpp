// The word `$`: M3, M4, M5, S, G96, G97 for one spindle or for all (spec/linuxcnc 8; convert_m, convert_speed, convert_spindle_mode of
// LinuxCNC's source).

#include "control/linuxcnc/spindles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "control/emitter.h"
#include "control/functions/functions.h"
#include "control/linuxcnc/linuxcnc.h"

namespace kadr::linuxcnc {
namespace {

constexpr int all_spindles = -1;

/// Returns the value of the word `$`, which is a spindle number, without decimals; nullopt if the block has no `$`.
std::optional<int> spindle_word(const BlockContext& m) {
  const char address = linuxcnc_of(m).spindle_address;
  if (address == 0 || !m.has(address)) return std::nullopt;
  constexpr double beyond = 1000;
  return static_cast<int>(std::clamp(m.word(address)->value, -beyond, beyond));
}

bool is_spindle(const LinuxCnc& control, int number) { return number >= 0 && number < control.machine.spindles; }

/// Calls `use` for each spindle that the word `$` selects. `number`: value of the word, which means one spindle or all of them.
template <class Use>
void each_spindle(const LinuxCnc& control, int number, Use use) {
  for (int i = 0; i < control.machine.spindles; ++i)
    if (number == all_spindles || i == number) use(i);
}

void command_spindle(Emitter& m, int number, SpindleDir dir) {
  if (number == 0) m.modal.spindle = dir;
  else linuxcnc_of(m).state.others[static_cast<std::size_t>(number)].dir = dir;
  m.emit(Spindle{dir, dir == SpindleDir::stop ? 0 : rpm_of(m, number), machine_number(number)});
}

}  // namespace

std::uint8_t machine_number(int number) { return static_cast<std::uint8_t>(number + 1); }

double rpm_of(const BlockContext& m, int number) {
  return number == 0 ? m.modal.rpm : linuxcnc_of(m).state.others[static_cast<std::size_t>(number)].rpm;
}

SpindleDir direction_of(const BlockContext& m, int number) {
  return number == 0 ? m.modal.spindle : linuxcnc_of(m).state.others[static_cast<std::size_t>(number)].dir;
}

double speed_of_block(const BlockContext& m, int number) {
  const int selected = spindle_word(m).value_or(0);
  return m.has('S') && (selected == number || selected == all_spindles) ? m.value('S') : rpm_of(m, number);
}

Status take_spindle(BlockContext& m, const char* text, Span where) {
  LinuxCnc& control = linuxcnc_of(m);
  const auto chosen = spindle_word(m);
  if (!chosen) return {};
  if (!is_spindle(control, *chosen)) return control.fault(AlarmId::rs274_spindle, where, text);
  control.state.active_spindle = *chosen;
  return {};
}

bool active_spindle_turns(const BlockContext& m) {
  const SpindleDir dir = direction_of(m, linuxcnc_of(m).state.active_spindle);
  return dir == SpindleDir::cw || dir == SpindleDir::ccw;
}

Status spindle_of_modes(BlockContext& m) {
  LinuxCnc& control = linuxcnc_of(m);
  const bool of_speed = control.codes.g[14] >= 0, of_feed = control.codes.g[5] >= 0;
  if (!of_speed && !of_feed) return {};
  control.state.active_spindle = 0;
  const Status taken = take_spindle(
      m, of_speed ? "Invalid spindle ($) number in Spindle Mode command" : "Invalid spindle ($) number in Spindle Feed command",
      m.block->where);
  // The feed per revolution of G95 counts the revolutions of the spindle that the word `$` selects.
  if (taken && of_feed) m.modal.main_spindle = machine_number(control.state.active_spindle);
  return taken;
}

void stop_other_spindles(Emitter& m) {
  LinuxCnc& control = linuxcnc_of(m);
  for (int i = 1; i < control.machine.spindles; ++i)
    if (control.state.others[static_cast<std::size_t>(i)].dir != SpindleDir::stop) command_spindle(m, i, SpindleDir::stop);
  control.state.active_spindle = 0;
  m.modal.main_spindle = machine_number(0);
}

/// Executes M3, M4, M5 for the spindles that the word `$` selects.
Result<bool> LinuxCnc::turns_spindle(Emitter& m, SpindleDir dir, Span where) {
  auto chosen = spindle_word(m);
  // M5 without `$` stops all spindles (LinuxCNC 2.9.3).
  if (!chosen && dir == SpindleDir::stop && machine.spindles > 1) chosen = all_spindles;
  if (!chosen) return false;
  if (*chosen != all_spindles && !is_spindle(*this, *chosen))
    return fault(AlarmId::rs274_spindle, where,
                 fmt::format("Spindle ($) number out of range in M{} Command num_spindles ={}. $={}",
                             dir == SpindleDir::cw    ? 3
                             : dir == SpindleDir::ccw ? 4
                                                      : 5,
                             machine.spindles, *chosen));
  each_spindle(*this, *chosen, [&](int i) { command_spindle(m, i, dir); });
  return true;
}

SurfaceSpeed LinuxCnc::surface_speed(const BlockContext& m) const {
  SurfaceSpeed speed = m.speed_by_x();
  constexpr double metres_per_foot = 0.3048;
  if (m.modal.inch) speed.metres *= metres_per_foot;
  if (state.max_css_speed > 0) speed.most = state.max_css_speed;
  return speed;
}

}  // namespace kadr::linuxcnc

namespace kadr::functions {

using linuxcnc::linuxcnc_of;

/// S: sets the speed of the spindle that the word `$` selects.
Status speed_of_spindle(Emitter& m, const Call& call) {
  linuxcnc::LinuxCnc& control = linuxcnc_of(m);
  const auto chosen = linuxcnc::spindle_word(m);
  if (!chosen) return speed_word(m, call);
  if (*chosen != linuxcnc::all_spindles && !linuxcnc::is_spindle(control, *chosen))
    return control.fault(AlarmId::rs274_spindle, call.where, "Invalid spindle ($) number in Spindle speed command");
  const double rpm = m.value('S');
  const bool starts = control.codes.m[7] == 3 || control.codes.m[7] == 4;  // M3 and M4 in the same block emit the speed themselves
  linuxcnc::each_spindle(control, *chosen, [&](int i) {
    if (i == 0) m.modal.rpm = rpm;
    else control.state.others[static_cast<std::size_t>(i)].rpm = rpm;
    const bool surface = i == 0 ? m.modal.surface_speed : control.state.others[static_cast<std::size_t>(i)].surface;
    if (!starts) m.emit(Speed{rpm, surface, linuxcnc::machine_number(i)});
  });
  return {};
}

/// G96 D S: constant surface speed. G97 (arg 1): constant spindle speed.
Status surface_speed_limited(Emitter& m, const Call& call) {
  linuxcnc::LinuxCnc& control = linuxcnc_of(m);
  const bool on = call.row->arg == 0;
  const int chosen = control.state.active_spindle;
  if (chosen != 0) {
    control.state.others[static_cast<std::size_t>(chosen)].surface = on;
    return {};
  }
  if (!on) {
    control.state.max_css_speed = 0;
    return spindle_rpm(m, call);
  }
  m.modal.surface_speed = true;
  control.state.max_css_speed = m.has('D') ? std::fabs(m.value('D')) : 0;
  m.emit(m.surface_speed());
  return {};
}

}  // namespace kadr::functions
