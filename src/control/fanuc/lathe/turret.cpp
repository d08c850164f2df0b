// T of lathes: the turret turns to the tool, geometry and wear take effect; G10 sets the table of turning tools (spec/fanuc-t 4,
// spec/haas-st 3).

#include <array>

#include "control/emitter.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/lathe/lathe.h"
#include "control/fanuc/words/coordinates.h"
#include "control/fanuc/words/data_lines.h"

namespace kadr::fanuc {
namespace {

constexpr std::uint32_t haas_geometry = 10;      // L of G10 for the geometry on a Haas (spec/haas-st 3)
constexpr std::uint32_t geometry_from = 10'000;  // P10000 + n of G10 is the geometry of offset n, P n its wear

/// The lengths of an offset along the axes of the channel, mm; X as a radius.
struct TurretLengths {
  Axes geometry{}, wear{};
};

/// The number of the tool and of its offset in a T word.
struct TurretCall {
  std::uint32_t tool = 0, offset = 0;
};

/// Returns the parts of a T word: T0101 and T101 are tool 1 with offset 1; with 5002#0 the last digit alone is the offset, with 5028 as
/// many digits as it says. INFERRED: T1 of a Haas is tool 1 without an offset (spec/haas-st 3, U).
TurretCall parts_of(const LatheSettings& s, std::uint32_t number) {
  constexpr std::uint32_t two_digits = 100;
  if (s.is_haas && number < two_digits) return {number, 0};
  return {number / s.offset_numbers, number % s.offset_numbers};
}

TurretLengths lengths_of(const BlockContext& m, const TurretCall& t) {
  TurretLengths of;
  if (t.offset == 0) return of;
  const ToolOffset none;
  const auto row = [&](std::uint32_t n) -> const ToolOffset& { return n < m.tables.offsets.size() ? m.tables.offsets[n] : none; };
  const ToolOffset& geometry = row(fanuc_of(m).settings.lathe.geometry_by_tool ? t.tool : t.offset);
  const ToolOffset& wear = row(t.offset);
  const double geometries[] = {geometry.length_x, geometry.length_y, geometry.length};
  const double wears[] = {wear.length_x_wear, wear.length_y_wear, wear.length_wear};
  for (int role = 1; role <= 3; ++role)
    if (const int axis = main_axis(m, role); axis >= 0) {
      const double sense = role == 1 && fanuc_of(m).state.second_turret ? -1 : 1;  // spec/fanuc-t 11.3
      of.geometry[static_cast<std::size_t>(axis)] = sense * geometries[role - 1];
      of.wear[static_cast<std::size_t>(axis)] = sense * wears[role - 1];
    }
  return of;
}

/// Puts lengths into force by a shift of the work system: the machine stands, the coordinates of the tool change.
void shift_frames(Emitter& m, const Axes& lengths) {
  m.modal.lengths = lengths;
  m.change_frames();
}

/// Puts the lengths of an offset into force. The parts that shift the work system change the tool's coordinates only. By the other parts
/// the axes move, in this block, unless the block has a motion, which then ends at its programmed point with the new offset, or 5002#6 lets
/// the wear wait for the next motion.
Status put_in_force(Emitter& m, const TurretLengths& now) {
  Fanuc& fanuc = fanuc_of(m);
  const LatheSettings& s = fanuc.settings.lathe;
  const Axes before = m.modal.lengths, worn_before = fanuc.state.wear;
  Axes shifted = before, whole{};
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    whole[a] = now.geometry[a] + now.wear[a];
    const double geometry_before = before[a] - worn_before[a];
    const double geometry = s.geometry_moves ? geometry_before : now.geometry[a];
    const double wear = s.wear_shifts ? now.wear[a] : worn_before[a];
    shifted[a] = geometry + wear;
  }
  fanuc.state.wear = now.wear;
  shift_frames(m, shifted);
  const Axes programmed = m.position.programmed;
  if (whole == shifted) return {};
  shift_frames(m, whole);
  const bool moves = m.has_axis_words() && !m.block_axes_taken;
  if (moves || (s.wear_waits && !s.geometry_moves)) {
    m.position.programmed = programmed;
    return {};
  }
  AxisMask named = 0;
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if (whole[a] != shifted[a]) named |= AxisMask{1} << a;
  // The motion by the wear is not part of the contour: like G53 it is not compensated
  const bool uncompensated = fanuc.uncompensated;
  fanuc.uncompensated = true;
  const Status moved = m.straight(MotionKind::rapid, programmed, named);
  fanuc.uncompensated = uncompensated;
  return moved;
}

}  // namespace

Status turret(Emitter& m, const Call& call) {
  constexpr double highest = 99'999'999;
  Fanuc& fanuc = fanuc_of(m);
  const auto number = m.whole('T', 0, highest);
  if (!number) return fail(number.error());
  const TurretCall t = parts_of(fanuc.settings.lathe, *number);
  constexpr std::uint32_t most_tool = 99;
  if (t.tool > most_tool) return fail(alarm(AlarmId::turret_number, call.where, m.block->text_of(call.where)));
  if (t.offset > max_offsets(m)) return fail(alarm(AlarmId::offset_number_large, call.where, m.block->text_of(call.where)));
  if (t.tool != 0) {
    m.modal.tool_selected = t.tool;
    m.use.note(UseKind::tool, t.tool, m.origin);
    const bool changes = m.modal.tool != t.tool;
    m.modal.tool = t.tool;
    m.use.change_to(t.tool);
    if (changes) m.emit(ToolChange{t.tool});
  }
  m.modal.corrector = t.offset;
  m.modal.offset_number = t.offset;
  m.modal.length_number = t.offset;
  const ToolOffset none;
  const ToolOffset& row = t.offset < m.tables.offsets.size() && t.offset != 0 ? m.tables.offsets[t.offset] : none;
  if (t.offset != 0) m.use.note(UseKind::length, t.offset, m.origin, row == none);
  fanuc.state.tool_radius = row.whole_radius();
  fanuc.state.nose = nose_in_force(m, static_cast<std::uint8_t>(row.tip_position));
  return put_in_force(m, lengths_of(m, t));
}

void end_turret_offset(BlockContext& m) {
  m.modal.lengths = {};
  m.modal.corrector = m.modal.offset_number = m.modal.length_number = 0;
  UndoableState& state = fanuc_of(m).state;
  state.wear = {};
  state.tool_radius = 0;
  state.nose = 0;
}

namespace {

/// A row of the table of turning tools, and which of its halves G10 sets. Row 0 stands for the shift of the work system.
struct OffsetPlace {
  std::uint32_t number = 0;
  bool geometry = false;
};

/// Returns the place that G10 sets. On a Fanuc P alone says it; on a Haas L10 is the geometry, L1 and L11 the wear, and P the number.
Result<OffsetPlace> offset_place(const BlockContext& m) {
  OffsetPlace place;
  if (m.has('L')) {
    const auto number = m.whole('P', 1, max_offsets(m));
    if (!number) return fail(number.error());
    return OffsetPlace{*number, m.value('L') == haas_geometry};
  }
  const auto p = m.whole('P', 0, geometry_from + m.def.behaviour.offsets);
  if (!p) return fail(alarm(AlarmId::table_kind_unknown, m.where('P'), m.value('P')));
  place.geometry = *p > geometry_from;
  place.number = place.geometry ? *p - geometry_from : *p;
  if (*p == geometry_from || place.number > max_offsets(m) || place.number >= m.tables.offsets.size())
    return fail(alarm(AlarmId::table_kind_unknown, m.where('P'), double(*p)));
  return place;
}

}  // namespace

bool is_turret_table(const BlockContext& m, std::uint32_t l) {
  constexpr std::uint32_t haas_wear[] = {1, 11};
  return is_haas(m) && (l == haas_geometry || l == haas_wear[0] || l == haas_wear[1]);
}

Status set_turret_offset(Emitter& m, const Call& call) {
  if (!m.has('P')) return fail(alarm(AlarmId::word_missing, call.where, 'P', call.row->code));
  const auto place = offset_place(m);
  if (!place) return fail(place.error());
  macro_b_of(m).endless.note_change();
  if (place->number == 0) return set_work_shift(m, call);
  const auto [number, geometry] = *place;
  const auto q = m.has('Q') ? m.whole('Q', 0, 9) : Result<std::uint32_t>(0);
  if (!q) return fail(alarm(AlarmId::offset_value, m.where('Q'), 'Q', m.value('Q')));
  ToolOffset& row = m.tables.offsets[number];
  m.journal.keep(row);
  const std::array<double*, 3> lengths = geometry ? std::array<double*, 3>{&row.length_x, &row.length_y, &row.length}
                                                  : std::array<double*, 3>{&row.length_x_wear, &row.length_y_wear, &row.length_wear};
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address == 0 || (m.letters.axes & letter_bit(w.address)) == 0) continue;
    const std::size_t axis = m.def.address(w.address).axis;
    const int role = fanuc_of(m).settings.axes[axis].role;
    if (role < 1 || role > 3) return fail(alarm(AlarmId::illegal_address, w.where, w.written));
    const bool halves = is_diameter(m, axis) && !fanuc_of(m).settings.lathe.offsets_are_radii;
    const double value = w.value * m.unit_scale() * (halves ? 0.5 : 1);
    double& to = *lengths[static_cast<std::size_t>(role - 1)];
    to = is_increment(m, w) ? to + value : value;
  }
  if (m.has('R')) (geometry ? row.radius : row.radius_wear) = m.length_value('R') * (fanuc_of(m).settings.offsets_are_diameters ? 0.5 : 1);
  if (m.has('Q')) row.tip_position = *q;
  fanuc_of(m).changed_offsets.push_back(number);
  return {};
}

}  // namespace kadr::fanuc
