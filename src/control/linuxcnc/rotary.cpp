// Rotary axes of one turn, and indexers (spec/linuxcnc 10.2; unwrap_rotary, convert_motion of the source).

#include "control/linuxcnc/rotary.h"

#include <fmt/format.h>

#include <cmath>

#include "control/interpreter.h"
#include "control/linuxcnc/linuxcnc.h"

namespace kadr::linuxcnc {
namespace {

constexpr char rotary_letters[] = {'A', 'B', 'C'};
constexpr double one_turn = 360;

/// To |value| within the turn, in the direction of its sign; -0 goes backwards.
double unwrapped(double value, double here) {
  double to = std::fabs(value) + std::floor(here / one_turn) * one_turn;
  const bool backwards = std::signbit(value);
  if (!backwards && to < here) to += one_turn;
  if (backwards && to > here) to -= one_turn;
  return to;
}

}  // namespace

Status LinuxCnc::target(const Interpreter& m, Axes& to, AxisMask& named) const {
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

Status indexers_allow(const Interpreter& m) {
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
