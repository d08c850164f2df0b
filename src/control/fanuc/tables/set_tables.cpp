// G10: sets offsets, work offsets and parameters (spec/nct/10 10.2.4, 10.2.5; 15 15.2; 12 12.4; 24 24.1), and opens the data lines that end
// with G11.

#include <cmath>

#include "control/emitter.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/lathe/lathe.h"
#include "control/fanuc/words/coordinates.h"
#include "control/fanuc/words/data_lines.h"

namespace kadr::fanuc {
namespace {

constexpr char rotation_letters[] = {'I', 'J', 'K'};  // letters of the angles by which a work offset is rotated in the planes G17, G18, G19

/// Sets a work offset by G10 L2, L20, L21. The new values replace the old values; in G91 or with the operator I, the new values are added
/// to the old values.
Status set_zero(Emitter& m, const Call& call, std::uint32_t index, bool common) {
  const bool adds = !m.modal.absolute;
  // On a control without a common work offset, the words L and P of the common offset set the shift of G52 (spec/haas 5.4).
  Axes& shift = m.def.has_common_zero() ? m.tables.common : m.modal.local;
  Axes& table = common ? shift : m.tables.zeros[index];
  Axes zero = table;  // the words change a copy of the work offset, so that the table is unchanged after an alarm
  // The lengths of a dynamic offset are radii (25.4.1). It is UNKNOWN whether I, J, K are allowed, so they raise an alarm.
  const bool dynamic = index >= all_systems;
  for (const char letter : rotation_letters)
    if ((common || dynamic) && m.has(letter)) return fail(alarm(AlarmId::illegal_address, m.where(letter), letter));
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address == 0 || (m.letters.axes & letter_bit(w.address)) == 0) continue;
    const AddressRow& row = m.def.address(w.address);
    double v = w.value * (row.unit == WordUnit::length ? m.unit_scale() : 1.0);
    if ((m.modal.diameter >> row.axis & 1u) != 0 && !dynamic) v /= 2;
    const bool add = adds || w.incremental || row.function == Function::increment_axis;
    zero[row.axis] = add ? zero[row.axis] + v : v;
    if (!(std::fabs(zero[row.axis]) <= farthest)) return fail(alarm(AlarmId::position_out_of_range, w.where, w.address, zero[row.axis]));
  }
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if (zero[a] != table[a]) m.journal.keep(table[a]), table[a] = zero[a];
  if (!common && !dynamic) {
    Vec3& angles = m.tables.rotations[index];
    double* const parts[] = {&angles.x, &angles.y, &angles.z};
    for (std::size_t i = 0; i < 3; ++i)
      if (m.has(rotation_letters[i])) m.journal.keep(*parts[i]), *parts[i] = m.value(rotation_letters[i]) + (adds ? *parts[i] : 0.0);
  }
  (void)call;
  fanuc_of(m).tables_changed = true;
  m.change_frames();
  return {};
}

/// Returns the value in a row of the offset table that word L of G10 selects: length, radius or corner radius, or the wear of one of these
/// (15.2). Returns nullptr for any other L.
double* offset_register(ToolOffset& offset, std::uint32_t l) {
  switch (l) {
    case 10: return &offset.length;
    case 11: return &offset.length_wear;
    case 12: return &offset.radius;
    case 13: return &offset.radius_wear;
    case 110:
    case 203: return &offset.corner;
    case 111:
    case 202: return &offset.corner_wear;
    default: return nullptr;
  }
}

Status set_offset(BlockContext& m, const Call& call, std::uint32_t l) {
  for (const char letter : {'P', 'R'})
    if (!m.has(letter)) return fail(alarm(AlarmId::word_missing, call.where, letter, call.row->code));
  const auto number = m.whole('P', 1, max_offsets(m));
  if (!number) return fail(number.error());
  m.journal.keep(m.tables.offsets[*number]);
  double* const to = offset_register(m.tables.offsets[*number], l);
  const Word& r = *m.word('R');
  const bool adds = !m.modal.absolute || r.incremental;
  *to = (adds ? *to : 0.0) + r.value * m.unit_scale() * (((l == 12 || l == 13) && fanuc_of(m).settings.offsets_are_diameters) ? 0.5 : 1.0);
  fanuc_of(m).changed_offsets.push_back(*number);
  return {};
}

/// Executes G10 L200 (wear) and L201 (geometry): sets X Y Z R Q of the offset table for turning (15.2). INFERRED: a value without a word in
/// the block remains unchanged.
Status set_turning_offset(BlockContext& m, const Call& call, bool wear) {
  if (!m.has('P')) return fail(alarm(AlarmId::word_missing, call.where, 'P', call.row->code));
  const auto number = m.whole('P', 1, max_offsets(m));
  if (!number) return fail(number.error());
  const auto q = m.has('Q') ? m.whole('Q', 0, 9) : Result<std::uint32_t>(0);
  if (!q) return fail(q.error());
  m.journal.keep(m.tables.offsets[*number]);
  ToolOffset& offset = m.tables.offsets[*number];
  const std::pair<char, double*> registers[] = {{'X', wear ? &offset.length_x_wear : &offset.length_x},
                                                {'Y', wear ? &offset.length_y_wear : &offset.length_y},
                                                {'Z', wear ? &offset.length_wear : &offset.length},
                                                {'R', wear ? &offset.radius_wear : &offset.radius}};
  for (const auto& [letter, to] : registers) {
    const Word* const w = m.word(letter);
    if (w == nullptr) continue;
    const bool adds = !m.modal.absolute || w->incremental;
    *to = (adds ? *to : 0.0) + w->value * m.unit_scale();
  }
  if (m.has('Q')) offset.tip_position = *q;
  fanuc_of(m).changed_offsets.push_back(*number);
  return {};
}

/// Executes G10 L52, L75, L76, L77: the lines that follow until G11 are data lines.
Status open_data(BlockContext& m, const Call& call, std::uint32_t l) {
  if (m.has_axis_words()) return fail(alarm(AlarmId::own_block, call.where, call.row->code));
  if (l == 52) {
    macro_b_of(m).state.data_mode = DataMode::parameters;
    return {};
  }
  return fanuc_of(m).open_tool_data(m, l, m.has('P') ? m.value('P') : 0, call.where);
}

}  // namespace

Status set_work_shift(Emitter& m, const Call& call) { return set_zero(m, call, 0, true); }

Status set_tables(Emitter& m, const Call& call) {
  if (!m.has('L') && m.def.behaviour.lathe == Lathe::fanuc) return set_turret_offset(m, call);
  if (!m.has('L')) return fail(alarm(AlarmId::word_missing, call.where, 'L', call.row->code));
  macro_b_of(m).endless.note_change();
  const auto l = m.whole('L', 1, 999);
  if (!l) return fail(l.error());
  if (*l == 52 || (*l >= 75 && *l <= 77)) return open_data(m, call, *l);
  const bool of_turning = *l >= 200 && *l <= 203;
  if (of_turning && !fanuc_of(m).settings.turning_offsets) return fail(alarm(AlarmId::value_out_of_range, m.where('L'), 'L', double(*l)));
  if (*l == 200 || *l == 201) return set_turning_offset(m, call, *l == 200);
  if (is_turret_table(m, *l)) return set_turret_offset(m, call);
  ToolOffset unused;
  const bool mill = m.def.behaviour.lathe == Lathe::none;
  if (mill && offset_register(unused, *l) != nullptr) return set_offset(m, call, *l);
  if (*l != 2 && *l != 20 && *l != 21) return fail(alarm(AlarmId::table_kind_unknown, m.where('L'), double(*l)));
  if (!m.has('P')) return fail(alarm(AlarmId::word_missing, call.where, 'P', call.row->code));
  const auto p = *l == 2    ? m.whole('P', 0, basic_systems)
                 : *l == 20 ? m.whole('P', 1, m.def.behaviour.further_systems)
                            : m.whole('P', 1, dynamic_systems);
  if (!p) return fail(p.error());
  const auto before = static_cast<std::uint32_t>(*l == 2 ? 0 : *l == 20 ? basic_systems : all_systems - 1);
  const std::uint32_t index = before + *p;
  return set_zero(m, call, index, *l == 2 && *p == 0);
}

Status data_line(Emitter& m) {
  if (m.has_code({Function::set_tables_end})) {
    if (m.block->word_count > 1) return fail(alarm(AlarmId::own_block, m.block->words[0].where, "G11"));
    macro_b_of(m).close_data();
    return {};
  }
  if (macro_b_of(m).state.data_mode == DataMode::parameters) return macro_b_of(m).parameter_line(m);
  return fanuc_of(m).tool_line(m);
}

/// Checks that a block has at most one M code of each exclusive group, and at most one spindle code (13.1, 11.2).
Status check_m_codes(const BlockContext& m) {
  const Settings& s = fanuc_of(m).settings;
  const auto is_spindle = [&](int code) {
    if (code == 3 || code == 4 || code == 5 || code == 19) return true;
    for (const SpindleSettings& spindle : s.spindles)
      if (spindle.m_high != 0 && code >= spindle.m_low && code <= spindle.m_high) return true;
    return false;
  };
  const auto contradict = [&](int a, int b) {
    if (is_spindle(a) && is_spindle(b)) return true;
    for (const auto& [low, high] : s.m_groups)
      if (high != 0 && a >= low && a <= high && b >= low && b <= high) return true;
    return false;
  };
  for (std::uint32_t i = 0; i < m.block->word_count; ++i)
    for (std::uint32_t k = i + 1; k < m.block->word_count; ++k) {
      const Word &a = m.block->words[i], &b = m.block->words[k];
      if (a.address != 'M' || b.address != 'M' || !contradict(a.code / 10, b.code / 10)) continue;
      return fail(alarm(AlarmId::m_codes_contradict, b.where, m.block->text_of(a.where), m.block->text_of(b.where)));
    }
  return {};
}

}  // namespace kadr::fanuc
