// Rotary axes that are wrapped (they count one revolution), and indexers (spec/linuxcnc 10.2; unwrap_rotary, convert_motion of LinuxCNC's
// source).

#include "control/linuxcnc/rotary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "control/emitter.h"
#include "control/linuxcnc/linuxcnc.h"

namespace kadr::linuxcnc {
namespace {

constexpr char rotary_letters[] = {'A', 'B', 'C'};
constexpr double one_turn = 360;

/// Returns the position to which a wrapped axis moves from the position `here`, degrees. The absolute value of `value` is the angle, and
/// its sign is the direction; -0 counts as negative.
double unwrapped(double value, double here) {
  double to = std::fabs(value) + std::floor(here / one_turn) * one_turn;
  const bool backwards = std::signbit(value);
  if (!backwards && to < here) to += one_turn;
  if (backwards && to > here) to -= one_turn;
  return to;
}

/// Returns true if G53 does not cancel the tool offset of a rotary axis. By a fault of LinuxCNC up to 2.9.10 (find_ends), this is so for
/// every axis that is not wrapped.
bool keeps_offset(const BlockContext& m, std::size_t axis) {
  const LinuxCnc& control = linuxcnc_of(m);
  for (std::size_t i = 0; i < control.machine.wrapped.size(); ++i)
    if (m.letters.axis_letter[axis] == rotary_letters[i])
      return !control.machine.wrapped[i] && m.has(rotary_letters[i]) && m.frames.length[axis] != 0;
  return false;
}

}  // namespace

bool LinuxCnc::shapes_lines(const BlockContext& m) const {
  if (!m.block_machine_coordinates) return false;
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if (keeps_offset(m, a)) return true;
  return false;
}

/// Executes a straight motion with G53 in which the tool offset of a rotary axis is not cancelled (see keeps_offset()), and warns.
Status LinuxCnc::straight(Emitter& m, const kadr::Call& call, MotionKind kind) {
  if (kind == MotionKind::feed) KADR_TRY(m.feed_known(call.where));
  Axes to = m.position.machine;
  AxisMask named = 0;
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    const char letter = m.letters.axis_letter[a];
    if (letter == 0 || !m.has(letter)) continue;
    const bool is_angle = std::find(std::begin(rotary_letters), std::end(rotary_letters), letter) != std::end(rotary_letters);
    const double half = (m.modal.diameter >> a & 1U) != 0 ? 0.5 : 1;
    to[a] = is_angle ? m.value(letter) : m.length_value(letter) * half;
    named |= AxisMask{1} << a;
    if (!keeps_offset(m, a)) continue;
    to[a] += m.frames.length[a];
    m.warn(warning(AlarmId::machine_move_with_offset, m.where(letter), letter, to[a]));
  }
  return m.to_machine(kind, to, named, 0);
}

Status LinuxCnc::target(const BlockContext& m, Axes& to, AxisMask& named) const {
  KADR_TRY(m.axis_words(to, named));
  if (!m.modal.absolute) return {};
  for (std::size_t i = 0; i < machine.wrapped.size(); ++i) {
    const char letter = rotary_letters[i];
    if (!machine.wrapped[i] || !m.has(letter)) continue;
    const auto axis = static_cast<std::size_t>(m.letters.axis_of[static_cast<std::size_t>(letter - 'A')]);
    const double value = m.value(letter);
    if (!(std::fabs(value) < one_turn))
      return fault(AlarmId::rs274_motion, m.where(letter),
                   fmt::format("Invalid absolute position {:5.2f} for wrapped rotary axis {}", value, letter));
    to[axis] = unwrapped(value, m.position.programmed[axis]);
  }
  return {};
}

Status indexers_allow(const BlockContext& m) {
  const LinuxCnc& control = linuxcnc_of(m);
  if (control.codes.motion < 0) return {};
  const auto wrong = [&](const char* text, char letter) {
    return control.fault(AlarmId::rs274_motion, m.where(letter), fmt::format("Indexing axis {} can only be moved {}", letter, text));
  };
  const auto each = [&](auto test) -> Status {
    for (std::size_t i = 0; i < control.machine.indexed.size(); ++i)
      if (control.machine.indexed[i] && m.has(rotary_letters[i])) KADR_TRY(test(rotary_letters[i]));
    return {};
  };
  if (control.codes.motion != 0) KADR_TRY(each([&](char letter) -> Status { return wrong("with G0", letter); }));
  return each([&](char letter) -> Status {
    for (const char other : axis_letters)
      if (other != letter && m.has(other)) return wrong("alone", letter);
    return {};
  });
}

}  // namespace kadr::linuxcnc
