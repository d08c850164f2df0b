#include "control/s2c42/musts.h"

#include "control/machinery.h"

namespace kadr::s2c42 {
namespace {

/// The first code of the block that calls one of these functions, or nullptr.
const Word* code_of(const Machinery& m, std::initializer_list<Function> functions) {
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    const std::int32_t row = w.code >= 0 ? m.def.row_of(w.address, w.code) : -1;
    if (row < 0) continue;
    for (const Function function : functions)
      if (m.def.codes[static_cast<std::size_t>(row)].function == function) return &w;
  }
  return nullptr;
}

void check_reference(Machinery& m) {
  const Word* const reference = code_of(m, {Function::approach_reference});
  if (reference == nullptr) return;
  if (m.musts.reference_seen) m.warn(warning(AlarmId::reference_again, reference->where));
  else if (m.musts.moved) m.warn(warning(AlarmId::reference_late, reference->where));
  m.musts.reference_seen = true;
}

/// INFERRED: G9 stands in the block with the new plane, as in table 9, or in the last one before it that moves.
void check_plane(Machinery& m, Plane before) {
  const Word* const plane = code_of(m, {Function::plane_xy, Function::plane_zx, Function::plane_yz});
  if (plane == nullptr || m.modal.plane == before || m.musts.at_rest || m.block_exact) return;
  m.warn(warning(AlarmId::plane_without_stop, plane->where, m.block->text_of(plane->where)));
}

/// M2 beside it ends the section (6.3.5).
void check_return(Machinery& m) {
  const Word* const end = code_of(m, {Function::subprogram_end});
  if (end == nullptr) return;
  const bool ends_section = code_of(m, {Function::program_end}) != nullptr;
  const std::uint32_t own = ends_section ? 2 : 1;
  if (m.block->word_count > own || !m.block->assignments.empty()) m.warn(warning(AlarmId::return_not_alone, end->where));
}

void check_length(Machinery& m) {
  const Word* const length = code_of(m, {Function::length_plus, Function::length_minus});
  const Word* const radius = code_of(m, {Function::radius_comp_left, Function::radius_comp_right, Function::compensation_off});
  if (length == nullptr || radius == nullptr) return;
  const Word* const second = length > radius ? length : radius;
  const Word* const first = length > radius ? radius : length;
  m.warn(warning(AlarmId::length_beside_radius, second->where, m.block->text_of(second->where), m.block->text_of(first->where)));
}

void note_motion(Machinery& m) {
  Musts& musts = m.musts;
  const bool calls = m.has('L');  // the cycles end at rest (table 9)
  const bool stands = code_of(m, {Function::dwell, Function::program_stop, Function::optional_stop, Function::change_tool}) != nullptr;
  const bool machine = code_of(m, {Function::approach_reference, Function::machine_point}) != nullptr;
  const bool takes_axes = code_of(m, {Function::zero_shift}) != nullptr;
  const bool moves = m.has_axis_words() && !takes_axes;
  if (moves && !machine) musts.at_rest = m.block_exact || m.modal.motion == MotionMode::rapid;
  if (stands || machine || calls) musts.at_rest = true;
  musts.moved = musts.moved || moves || machine || calls;
}

}  // namespace

BlockBefore before(const Machinery& m) { return {m.flow.in_body(), m.modal.plane}; }

void check_musts(Machinery& m, const BlockBefore& before) {
  if (before.in_body) {
    m.musts.moved = m.musts.at_rest = true;
    return;
  }
  check_reference(m);
  check_plane(m, before.plane);
  check_return(m);
  check_length(m);
  note_motion(m);
}

void warn_of_shadow(Machinery& m, std::uint32_t number, Span where) {
  const std::uint64_t bit = number < 128 && number >= 64 ? std::uint64_t{1} << (number - 64) : 0;
  if (bit == 0 || (m.musts.shadows & bit) != 0) return;
  m.musts.shadows |= bit;
  m.warn(warning(AlarmId::subprogram_shadowed, where, double(number)));
}

}  // namespace kadr::s2c42
