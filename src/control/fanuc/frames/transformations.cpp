// Rotation, scaling, mirroring: G68, G51, G51.1 (spec/nct/16). Used by control/fanuc/drilling/drilling, control/fanuc/dialect; tested by
// tests/control/fanuc/transformations_test.cpp.

#include "control/fanuc/frames/transformations.h"

#include <algorithm>
#include <cmath>

#include "base/code_literals.h"
#include "control/fanuc/drilling/drilling.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"

namespace kadr::fanuc {
namespace {

/// Changes mirroring, scaling or rotation by calling `change`. The tool and the initial level of a drilling cycle keep their real
/// positions, so the programmed coordinates of both change (16.0, INFERRED).
template <class Change>
void change_transform(BlockContext& m, Change change) {
  const Axes tool = before_transform(m);
  DrillingMemory& drilling = fanuc_of(m).state.drilling;
  Axes initial = m.position.programmed;
  initial[drilling.axis] = drilling.initial;
  initial = m.transform.to_work(initial);
  change(m.transform);
  m.transform.refresh();
  m.position.programmed = m.transform.to_programmed(tool);
  if (drilling_on(m)) drilling.initial = m.transform.to_programmed(initial)[drilling.axis];
}

/// Calls `use(axis, centre)` for each coordinate of the centre in the block. The centre is Cartesian even in G16 (polar coordinates); an
/// increment counts from the programmed position (16.0).
template <class Use>
Status each_center(const BlockContext& m, Use use) {
  AxisMask named = 0;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address == 0 || (m.letters.axes & letter_bit(w.address)) == 0) continue;
    const std::size_t axis = m.def.address(w.address).axis;
    if ((named >> axis & 1u) != 0) return fail(alarm(AlarmId::address_twice, w.where, w.address));
    named |= AxisMask{1} << axis;
    const double v = coordinate(m, w, axis);
    const double center = is_increment(m, w) ? m.position.programmed[axis] + v : v;
    if (!(std::fabs(center) <= farthest)) return fail(alarm(AlarmId::position_out_of_range, w.where, w.address, center));
    use(axis, center);
  }
  return {};
}

/// Checks that mirroring may change. Mirroring is the outermost transformation, so scaling and rotation must be off (16.4).
Status mirror_may_change(const BlockContext& m, const Call& call) {
  if (!m.transform.scaling && !m.transform.turning) return {};
  return fail(alarm(AlarmId::mirror_state, call.where, call.row->code, m.transform.scaling ? "G51" : "G68"));
}

/// Raises an alarm for scaling or rotation during cylindrical interpolation, where degrees and millimetres would mix. The manual (4.6) does
/// not mention this case.
Status flat_surface(const BlockContext& m, const Call& call) {
  if (m.modal.surface == PathSurface::cylinder) return fail(alarm(AlarmId::not_available, call.where, call.row->code));
  return {};
}

bool is_linear(const BlockContext& m, std::size_t axis) {
  const bool is_virtual = m.modal.surface == PathSurface::polar && axis == m.modal.axes.second;
  return is_virtual || (m.def.rotary >> axis & 1u) == 0;
}

/// Reads the scale factors: P for every linear axis, or I, J, K for X, Y, Z. INFERRED: a missing factor is 1.
///   alarms  word_missing, not_together, scale_zero, value_out_of_range, illegal_address
Status read_factors(Emitter& m, const Call& call, Axes& factors) {
  factors.fill(1);
  const Settings& settings = fanuc_of(m).settings;
  // On a control with parameter 5400, its bit 6 decides whether G51 may give the scale factors I, J, K (spec/fanuc 6.9).
  const bool by_parameter = !m.def.grammar.least_increments.empty();
  const bool each = (m.has('I') || m.has('J') || m.has('K')) && (!by_parameter || settings.scale_each);
  if (by_parameter && !each)
    for (const char letter : {'I', 'J', 'K'})
      if (m.has(letter)) m.warn(warning(AlarmId::word_passed_over, m.where(letter), m.block->text_of(m.where(letter))));
  // without P, the scale factor of G51 is that of parameter 5411 (spec/fanuc 6.9) or setting 71 (spec/haas 6.3)
  if (!each && !m.has('P') && settings.scale_usual != 0) {
    for (std::size_t a = 0; a < m.axis_count; ++a)
      if (is_linear(m, a)) factors[a] = settings.scale_usual;
    return {};
  }
  // G51 has no P, and parameter 5411 is 0, so there is no scale factor
  if (by_parameter && !each && !m.has('P')) return fail(alarm(AlarmId::scale_zero, call.where, 'P'));
  if (!each && !m.has('P')) return fail(alarm(AlarmId::word_missing, call.where, 'P', call.row->code));
  if (each && m.has('P')) return fail(alarm(AlarmId::not_together, m.where('P'), "P", "I J K"));
  for (const char letter : {'P', 'I', 'J', 'K'})
    if (m.has(letter) && m.value(letter) == 0) return fail(alarm(AlarmId::scale_zero, m.where(letter), letter));
  if (!each) {
    const bool counted = !m.word('P')->has_point && !m.word('P')->expression;
    const double factor = m.value('P') * (counted ? settings.scale_unit : 1);
    // a negative P is an error: only a negative I, J or K mirrors
    if (factor < 0) return fail(alarm(AlarmId::value_out_of_range, m.where('P'), 'P', factor));
    for (std::size_t a = 0; a < m.axis_count; ++a)
      if (is_linear(m, a)) factors[a] = factor;
    return {};
  }
  for (int role = 1; role <= 3; ++role) {
    const char letter = static_cast<char>('I' + role - 1);
    const int axis = main_axis(m, role);
    if (m.has(letter) && axis < 0) return fail(alarm(AlarmId::illegal_address, m.where(letter), letter));
    if (m.has(letter)) factors[static_cast<std::size_t>(axis)] = m.value(letter);
  }
  return {};
}

}  // namespace

void clear_mirror(BlockContext& m) {
  change_transform(m, [](Transform& t) {
    t.mirror.fill(1);
    t.added.fill(0);
  });
}

void note_mirror_code(BlockContext& m, const CodeRow& row) {
  constexpr std::int32_t mirror_code = 51.1_g;
  const auto& mirror = m.transform.mirror;
  if (row.function == Function::mirror_off && std::find(mirror.begin(), mirror.end(), -1) != mirror.end())
    m.modal.rows[row.group] = static_cast<std::int16_t>(m.def.row_of('G', mirror_code));
}

}  // namespace kadr::fanuc

namespace kadr::functions {

using namespace fanuc;
namespace {

/// Ends mirroring on the named axes. INFERRED: without axis words, it ends on all axes.
Status end_mirror(BlockContext& m) {
  if (!m.has_axis_words()) {
    clear_mirror(m);
    return {};
  }
  AxisMask named = 0;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address != 0 && (m.letters.axes & letter_bit(w.address)) != 0) named |= AxisMask{1} << m.def.address(w.address).axis;
  }
  change_transform(m, [&](Transform& t) {
    for (std::size_t a = 0; a < m.axis_count; ++a)
      if ((named >> a & 1u) != 0) t.mirror[a] = 1, t.added[a] = 0;
  });
  return {};
}

}  // namespace

/// G51.1 (16.3): mirrors the named axes about the given coordinates. alarms mirror_state, no_axis_word
Status mirror_on(Emitter& m, const Call& call) {
  KADR_TRY(mirror_may_change(m, call));
  if (!m.has_axis_words()) return fail(alarm(AlarmId::no_axis_word, call.where, call.row->code));
  auto mirror = m.transform.mirror;
  Axes added = m.transform.added;
  KADR_TRY(each_center(m, [&](std::size_t axis, double line) {
    mirror[axis] = -1;
    added[axis] = 2 * line;
  }));
  change_transform(m, [&](Transform& t) {
    t.mirror = mirror;
    t.added = added;
  });
  return {};
}

/// G101 X0 Y0 (spec/haas 6.1): mirrors the named axes about the work origin; the numbers in the words have no meaning. INFERRED: G101 is
/// allowed while G51 or G68 is in force, because the control has no alarm for this case.
Status mirror_axes_on(Emitter& m, const Call&) {
  auto mirror = m.transform.mirror;
  Axes added = m.transform.added;
  KADR_TRY(each_center(m, [&](std::size_t axis, double) {
    mirror[axis] = -1;
    added[axis] = 0;
  }));
  change_transform(m, [&](Transform& t) {
    t.mirror = mirror;
    t.added = added;
  });
  return {};
}

Status mirror_axes_off(Emitter& m, const Call&) { return end_mirror(m); }

/// G50.1: ends mirroring on the named axes. INFERRED: without axis words, it ends on all axes. alarms mirror_state
Status mirror_off(Emitter& m, const Call& call) {
  KADR_TRY(mirror_may_change(m, call));
  return end_mirror(m);
}

/// G51 (16.2): switches scaling on. For a missing coordinate of the centre, the present position is used. If scaling is already on, the
/// order of the transformations does not change.
Status scaling_on(Emitter& m, const Call& call) {
  KADR_TRY(flat_surface(m, call));
  Axes factors;
  KADR_TRY(read_factors(m, call, factors));
  Axes center = m.position.programmed;
  KADR_TRY(each_center(m, [&](std::size_t axis, double at) { center[axis] = at; }));
  change_transform(m, [&](Transform& t) {
    if (!t.scaling) t.turned_last = true;
    t.scaling = true;
    t.scale = factors;
    for (std::size_t a = 0; a < m.axis_count; ++a) t.scale_shift[a] = center[a] * (1 - factors[a]);
  });
  return {};
}

Status scaling_off(Emitter& m, const Call&) {
  if (!m.transform.scaling) return {};
  change_transform(m, [](Transform& t) {
    t.scaling = false;
    t.scale.fill(1);
    t.scale_shift.fill(0);
  });
  return {};
}

/// G68 (16.1): rotates by R about a point of the plane. An incremental R adds to the angle in force. INFERRED: without R the angle in
/// force remains.
Status plane_rotation_on(Emitter& m, const Call& call) {
  KADR_TRY(flat_surface(m, call));
  const PlaneAxes& plane = m.modal.axes;
  if (!is_linear(m, plane.first) || !is_linear(m, plane.second)) return fail(alarm(AlarmId::plane_wrong, call.where, call.row->code));
  const Word* const r = m.word('R');
  const fanuc::Settings& settings = fanuc_of(m).settings;
  // spec/fanuc 6.8, spec/haas 6.2: a parameter decides whether R is incremental in G91; if not, R is absolute in G91 too
  const bool by_parameter = !m.def.grammar.least_increments.empty();
  const bool adds =
      by_parameter ? r != nullptr && !m.modal.absolute && settings.rotation_adds : r == nullptr || r->incremental || !m.modal.absolute;
  const double angle = r == nullptr && by_parameter ? settings.rotation_usual : m.value('R');
  Axes center = m.position.programmed;
  KADR_TRY(each_center(m, [&](std::size_t axis, double at) { center[axis] = at; }));
  change_transform(m, [&](Transform& t) {
    if (!t.turning) t.turned_last = !t.scaling;
    t.turning = true;
    t.rotation = (adds ? t.rotation : 0.0) + angle;
    t.rotation_center = {center[plane.first], center[plane.second]};
    t.first = static_cast<std::uint8_t>(plane.first);
    t.second = static_cast<std::uint8_t>(plane.second);
  });
  return {};
}

Status plane_rotation_off(Emitter& m, const Call&) {
  if (!m.transform.turning) return {};
  change_transform(m, [](Transform& t) {
    t.turning = false;
    t.rotation = 0;
  });
  return {};
}

}  // namespace kadr::functions
