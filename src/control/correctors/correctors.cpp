// The dialect of the generic Soviet ISO control: axis correctors, which are offsets of axes (spec/correctors 1), and pockets
// (spec/correctors 3). Used by control/correctors/pocket.

#include "control/correctors/correctors.h"

#include <bit>
#include <cmath>

#include "base/tolerance.h"
#include "control/correctors/pocket.h"
#include "control/emitter.h"
#include "control/functions/functions.h"

namespace kadr {

using correctors::correctors_of;
using correctors::PocketCut;
using correctors::PocketCycle;

namespace {

constexpr std::size_t corrected_axes = 3;  // X, Y, Z
constexpr double max_rounds = 1e6;         // greatest number of closed paths in a pocket; a larger number is a mistake in K or I

/// The result of reading an L word: the corrector (offset row) that the word names, and the axes that the corrector shifts.
struct Named {
  AxisMask axes = 0;
  std::size_t number = 0;
};

/// Reads an L word, which has two forms. In `L2 15` the first number names the axes (1 for X, 2 for Y, 4 for Z, or a sum of these), and 15
/// is the number of the corrector. `L17` names corrector 17, which shifts the only axis that has a word in the block.
Result<Named> read(const BlockContext& m, const Word& w) {
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

/// Returns the tool radius in mm; 0 if the radius is unknown. The radius is the value of the corrector (offset) that T names; T0915, for
/// example, names corrector 15 (spec/correctors 2).
double tool_radius(BlockContext& m) {
  const std::size_t number = m.modal.corrector;
  if (number == 0 || number >= m.tables.correctors.size()) return 0;
  const double stored = number < m.tables.offsets.size() ? m.tables.offsets[number].whole_radius() : 0.0;
  const double radius = std::fabs(stored != 0 ? stored : m.tables.correctors[number]);
  m.use.note(UseKind::corrector, static_cast<std::uint32_t>(number), m.origin, radius == 0);
  return radius;
}

/// Warns if the rapid motion down to the clearance of a pocket would enter the workpiece, as far as the program shows. The motion would do
/// so if the face of the pocket is below the face of an earlier pocket. There is no warning if the pocket starts on the floor of a larger
/// pocket, as in the manual's figure b (spec/correctors 3).
void warn_above_solid(Emitter& m, Span where, const Axes& middle) {
  correctors::Correctors& own = correctors_of(m);
  constexpr std::size_t max_pockets = 1000;
  const PocketCut now = {{middle[0], middle[1]}, {own.pocket.x / 2, own.pocket.y / 2}, middle[2], middle[2] + own.pocket.z};
  bool deeper = false, begun = false;
  for (const PocketCut& cut : own.pockets_cut) {
    deeper = deeper || now.face < cut.face - tol::same_point;
    const bool inside = std::fabs(now.middle.x - cut.middle.x) + now.half.x <= cut.half.x + tol::same_point &&
                        std::fabs(now.middle.y - cut.middle.y) + now.half.y <= cut.half.y + tol::same_point;
    begun = begun || (inside && cut.floor <= now.face + tol::same_point);
  }
  if (deeper && !begun) m.warn(warning(AlarmId::pocket_above_solid, where, now.face));
  if (own.pockets_cut.size() < max_pockets) own.pockets_cut.push_back(now);
}

}  // namespace

namespace correctors {

Correctors::Correctors(const BlockContext& m, const Setup& setup) {
  is_set.resize(m.def.behaviour.offsets + 1);
  applied.resize(is_set.size() * corrected_axes);
  for (const auto& [number, mm] : setup.correctors)
    if (number >= 0 && static_cast<std::size_t>(number) < is_set.size()) is_set[static_cast<std::size_t>(number)] = true;
}

Correctors& correctors_of(const BlockContext& m) { return static_cast<Correctors&>(*m.dialect); }

BlockChanges Correctors::changes_of(const BlockContext& m, const Plan& plan) const {
  return m.has('L') ? BlockChanges::anything : Dialect::changes_of(m, plan);
}

void Correctors::begin_block(Emitter&) { state_saved_ = false; }

void Correctors::keep(BlockContext&) {
  before_ = {pocket, applied};
  state_saved_ = true;
}

void Correctors::undo_block(BlockContext&) {
  if (!state_saved_) return;
  pocket = before_.pocket;
  applied = before_.applied;
}

namespace {
struct CorrectorsState : DialectState, Memory {
  explicit CorrectorsState(const Memory& all) : Memory(all) {}
};
}  // namespace

std::shared_ptr<const DialectState> Correctors::snapshot() const { return std::make_shared<CorrectorsState>(*this); }

Status Correctors::restore(BlockContext&, const DialectState& from) {
  static_cast<Memory&>(*this) = static_cast<const CorrectorsState&>(from);
  return {};
}

bool Correctors::adds_to_motion(const BlockContext& m) const { return m.has('L'); }

Result<AxisMask> Correctors::add_to_motion(Emitter& m) {
  AxisMask moved = 0;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address != 'L') continue;
    const auto named = read(m, w);
    if (!named) return fail(named.error());
    if (!is_set[named->number]) {  // the panel has no value for the corrector, so the motion is not shifted, and a warning is reported once
      is_set[named->number] = true;
      m.warn(warning(AlarmId::corrector_not_set, w.where, double(named->number)));
    }
    const double stored = m.tables.correctors[named->number];
    if (named->number != 0) m.use.note(UseKind::corrector, static_cast<std::uint32_t>(named->number), m.origin, stored == 0);
    const double counted = m.modal.corrector_sign == 0 ? stored : m.modal.corrector_sign * std::fabs(stored);
    for (std::size_t a = 0; a < corrected_axes; ++a) {
      if ((named->axes >> a & 1u) == 0) continue;
      double& last = applied[named->number * corrected_axes + a];
      double& added = m.transform.added[a];
      moved |= 1u << a;
      if (m.has_code({Function::corrector_cancel})) {
        // The code that cancels correctors (offsets) subtracts, from the shift of the axis, the value that this corrector added last. If
        // the corrector has added no value yet, its stored value is subtracted (spec/correctors 1).
        const double back = last != 0 ? last : stored;
        added = m.modal.absolute ? 0.0 : added - back;
        last = 0;
      } else {
        // INFERRED: in G90 the corrector shifts the coordinate, so a second word L does not add the value again. In G91 the corrector
        // lengthens each motion.
        added = m.modal.absolute ? counted : added + counted;
        last = counted;
      }
    }
  }
  if (moved != 0) m.transform.refresh();
  return moved;
}

}  // namespace correctors

namespace functions {

Status corrector_plus(Emitter& m, const Call&) {
  m.modal.corrector_sign = +1;
  return {};
}
Status corrector_minus(Emitter& m, const Call&) {
  m.modal.corrector_sign = -1;
  return {};
}
Status corrector_cancel(Emitter& m, const Call& call) {
  m.modal.corrector_sign = 0;
  if (call.row->group != 0) m.modal.rows[call.row->group] = -1;
  return {};
}

/// G87: stores a rectangular pocket; nothing moves.
Status pocket_define(Emitter& m, const Call& call) {
  for (const char letter : {'X', 'Y', 'Z', 'R', 'I', 'J', 'K'})
    if (!m.has(letter)) return fail(alarm(AlarmId::word_missing, call.where, letter, call.row->code));
  constexpr double max_stepover = 40;  // % of the tool's diameter: greatest distance of two neighbouring paths (spec/correctors 3)
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
  p.feed = m.value('F');
  if (!(p.stepover > 0 && p.stepover <= max_stepover))
    return fail(alarm(AlarmId::stepover_out_of_range, m.where('I'), p.stepover, max_stepover));
  if (std::fabs(p.direction) != 1) return fail(alarm(AlarmId::value_out_of_range, m.where('J'), 'J', p.direction));
  if (!(p.pass > 0)) return fail(alarm(AlarmId::value_out_of_range, m.where('K'), 'K', p.pass));
  if (!(p.z < 0)) return fail(alarm(AlarmId::value_out_of_range, m.where('Z'), 'Z', p.z));
  if (p.clearance < 0) return fail(alarm(AlarmId::value_out_of_range, m.where('B'), 'B', p.clearance));
  for (const char letter : {'X', 'Y'})
    if (!(m.value(letter) > 0)) return fail(alarm(AlarmId::value_out_of_range, m.where(letter), letter, m.value(letter)));
  correctors_of(m).pocket = p;
  return {};
}

/// G79: cuts the stored pocket at the programmed point, in the plane XY.
Status pocket_run(Emitter& m, const Call& call) {
  const PocketCycle& pocket = correctors_of(m).pocket;
  if (!pocket.defined) return fail(alarm(AlarmId::cycle_undefined, call.where, call.row->code));
  if (m.modal.plane != Plane::xy) return fail(alarm(AlarmId::plane_wrong, call.where, call.row->code));
  if (!m.has('Z')) return fail(alarm(AlarmId::word_missing, call.where, 'Z', call.row->code));
  const double radius = tool_radius(m);
  if (radius == 0) return fail(alarm(AlarmId::pocket_tool_missing, call.where, double(m.modal.corrector)));
  const auto rounds = correctors::PocketRounds::of(pocket, radius, call.where);
  if (!rounds) return fail(rounds.error());
  const double all = rounds->count() * correctors::PocketRun::passes(pocket);
  if (!(all <= max_rounds)) return fail(alarm(AlarmId::pocket_too_long, call.where, all));
  if (pocket.feed > 0) m.modal.feed = pocket.feed;
  KADR_TRY(m.feed_known(call.where));
  Axes middle;
  AxisMask named = 0;
  KADR_TRY(m.target(middle, named));
  warn_above_solid(m, call.where, middle);
  m.running = std::make_unique<correctors::PocketRun>(pocket, *rounds, middle);
  return {};
}

}  // namespace functions
std::unique_ptr<Dialect> make_correctors_dialect(const BlockContext& m, const Setup& setup) {
  return std::make_unique<correctors::Correctors>(m, setup);
}

}  // namespace kadr
