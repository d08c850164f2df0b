#include "control/correctors/correctors.h"

#include <bit>
#include <cmath>

#include "control/functions.h"

namespace kadr {
namespace {

constexpr std::size_t corrected_axes = 3;  // X, Y, Z

/// Which axes and which corrector an L word names.
struct Named {
  AxisMask axes = 0;
  std::size_t number = 0;
};

/// `L2 15`: axes by a bit sum 1 X, 2 Y, 4 Z, then the corrector. `L17`: corrector 17 on the one axis that moves.
Result<Named> read(const Machinery& m, const Word& w) {
  Named named;
  const bool pair = !std::isnan(w.second);
  const double number = pair ? w.second : w.value;
  if (number != std::floor(number) || number < 0 || number >= static_cast<double>(m.tables.correctors.size()))
    return fail(alarm(AlarmId::corrector_unknown, w.where, number));
  named.number = static_cast<std::size_t>(number);
  if (pair) {
    if (w.value != std::floor(w.value) || w.value < 1 || w.value > 7) return fail(alarm(AlarmId::corrector_axis, w.where, number));
    named.axes = static_cast<AxisMask>(w.value);
    return named;
  }
  for (std::size_t a = 0; a < corrected_axes; ++a)
    if (m.has(m.letters.axis_letter[a])) named.axes |= 1u << a;
  if (std::popcount(named.axes) != 1) return fail(alarm(AlarmId::corrector_axis, w.where, w.value));
  return named;
}

}  // namespace

Result<AxisMask> correctors::apply(Machinery& m) {
  AxisMask moved = 0;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address != 'L') continue;
    const auto named = read(m, w);
    if (!named) return fail(named.error());
    const double stored = m.tables.correctors[named->number];
    const double counted = m.modal.corrector_sign == 0 ? stored : m.modal.corrector_sign * std::fabs(stored);
    for (std::size_t a = 0; a < corrected_axes; ++a) {
      if ((named->axes >> a & 1u) == 0) continue;
      double& applied = m.corrector_applied[named->number * corrected_axes + a];
      double& added = m.transform.added[a];
      moved |= 1u << a;
      if (m.has_code({Function::corrector_cancel})) {
        // With the opposite sign, what it added last; never added: its stored value (spec/correctors 1).
        const double back = applied != 0 ? applied : stored;
        added = m.modal.absolute ? 0.0 : added - back;
        applied = 0;
      } else {
        // INFERRED: with G90 the corrector belongs to the coordinate (not added again and again), with G91 to the motion.
        added = m.modal.absolute ? counted : added + counted;
        applied = counted;
      }
    }
  }
  if (moved != 0) m.transform.refresh();
  return moved;
}

namespace functions {

Status corrector_plus(Machinery& m, const Call&) { return m.modal.corrector_sign = +1, Status(); }
Status corrector_minus(Machinery& m, const Call&) { return m.modal.corrector_sign = -1, Status(); }
Status corrector_cancel(Machinery& m, const Call& call) {
  m.modal.corrector_sign = 0;
  if (call.row->group != 0) m.modal.rows[call.row->group] = -1;
  return {};
}

/// G87: stores a rectangular pocket; nothing moves.
Status pocket_define(Machinery& m, const Call& call) {
  for (const char letter : {'X', 'Y', 'Z', 'R', 'I', 'J', 'K'})
    if (!m.has(letter)) return fail(alarm(AlarmId::word_missing, call.where, letter, call.row->code));
  constexpr double most_stepover = 40;  // % of the tool's diameter (spec/correctors 3)
  PocketCycle p;
  p.defined = true;
  p.x = m.value('X');
  p.y = m.value('Y');
  p.z = m.value('Z');
  p.clearance = m.value('B');
  p.corner = m.value('R');
  p.stepover = m.value('I');
  p.direction = m.value('J');
  p.pass = m.value('K');
  if (!(p.stepover > 0 && p.stepover <= most_stepover))
    return fail(alarm(AlarmId::stepover_out_of_range, m.where('I'), p.stepover, most_stepover));
  if (std::fabs(p.direction) != 1) return fail(alarm(AlarmId::value_out_of_range, m.where('J'), 'J', p.direction));
  if (!(p.pass > 0)) return fail(alarm(AlarmId::value_out_of_range, m.where('K'), 'K', p.pass));
  for (const char letter : {'X', 'Y'})
    if (!(m.value(letter) > 0)) return fail(alarm(AlarmId::value_out_of_range, m.where(letter), letter, m.value(letter)));
  m.pocket = p;
  return {};
}

/// G79: runs it at a point. Its area clearing belongs to the contour work.
Status pocket_run(Machinery& m, const Call& call) {
  if (!m.pocket.defined) return fail(alarm(AlarmId::cycle_undefined, call.where, call.row->code));
  return fail(alarm(AlarmId::pocket_not_available, call.where));
}

}  // namespace functions
}  // namespace kadr
