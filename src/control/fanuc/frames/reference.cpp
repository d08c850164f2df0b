// Reference points: G27, G28, G29, G30 (spec/nct/09, spec/fanuc 6.6, spec/haas 5.1); single-direction positioning G60.

#include <cmath>

#include "control/fanuc/drilling/drilling.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"

namespace kadr::functions {
namespace {

constexpr double same_place = 1e-4;  // mm; positions that differ by less count as equal

/// Checks that no drilling cycle is in force, on a control where G80 must end the cycle before a reference return (spec/fanuc 10.1, alarm
/// PS0044).
Status outside_cycles(const BlockContext& m, const Call& call) {
  if (!fanuc::drilling_on(m) || !m.def.gives(AlarmId::reference_in_cycle)) return {};
  return fail(alarm(AlarmId::reference_in_cycle, call.where, call.row->code));
}

/// Checks that neither polar nor cylindrical interpolation is on (4.5, 4.6).
Status off_surfaces(const BlockContext& m, const Call& call) {
  if (m.modal.surface == PathSurface::plane) return {};
  return fail(alarm(AlarmId::surface_state, call.where, call.row->code));
}

/// Reads the point that the axis words give. The point is Cartesian even while G16 (polar coordinates) is in force.
Status point_of(BlockContext& m, Axes& to, AxisMask& named) {
  fanuc_of(m).cartesian_block = true;
  const Status read = m.target(to, named);
  fanuc_of(m).cartesian_block = false;
  return read;
}

Status to_reference(Emitter& m, std::uint32_t point, AxisMask named) {
  const auto end = static_cast<EndReference>(static_cast<std::uint32_t>(EndReference::reference_1) + point - 1);
  KADR_TRY(m.to_machine(MotionKind::rapid, m.tables.reference[point], named, 0, end));
  macro_b_of(m).moved = false;
  macro_b_of(m).stops_reading = true;
  return {};
}

}  // namespace

/// G28, G30 P (9.1, 9.2): moves at rapid through the intermediate point to a reference point. If call.row->arg is 1, this is reference
/// point 1.
Status reference_return(Emitter& m, const Call& call) {
  KADR_TRY(outside_cycles(m, call));
  KADR_TRY(off_surfaces(m, call));
  std::uint32_t point = 1;
  if (call.row->arg == 2) {
    // spec/fanuc 6.6: G30 without P means reference point 2
    const bool needed = (call.row->needs & letter_bit('P')) != 0, usual = !needed && !m.has('P');
    if (needed && !m.has('P')) return fail(alarm(AlarmId::word_missing, call.where, 'P', call.row->code));
    const auto number = usual ? Result<std::uint32_t>(2U) : m.whole('P', 1, 4);
    if (!number) return fail(number.error());
    point = *number;
  }
  if (!m.has_axis_words()) {
    if (m.def.behaviour.reference_all_axes) return to_reference(m, point, (AxisMask{1} << m.axis_count) - 1);
    if (!call.row->needs_axis) {  // spec/fanuc 6.6: it is UNKNOWN which axes move if the block has no axis words
      m.warn(warning(AlarmId::reference_without_axes, call.where, call.row->code));
      return {};
    }
    return fail(alarm(AlarmId::no_axis_word, call.where, call.row->code));
  }
  AxisMask named = 0;
  Axes through;
  KADR_TRY(point_of(m, through, named));
  KADR_TRY(m.straight(MotionKind::rapid, through, named));
  fanuc_of(m).state.through = m.position.programmed;
  fanuc_of(m).state.has_through = true;
  return to_reference(m, point, named);
}

/// G27 (spec/fanuc 6.6): moves at rapid to the given point, and checks that the point is the reference point of the named axes.
Status reference_check(Emitter& m, const Call& call) {
  KADR_TRY(outside_cycles(m, call));
  KADR_TRY(off_surfaces(m, call));
  if (!m.has_axis_words()) return {};
  AxisMask named = 0;
  Axes to;
  KADR_TRY(point_of(m, to, named));
  KADR_TRY(m.straight(MotionKind::rapid, to, named));
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if ((named >> a & 1U) != 0 && std::fabs(m.position.machine[a] - m.tables.reference[1][a]) > same_place)
      return fail(alarm(AlarmId::reference_missed, call.where, std::string_view(m.axis_names[a]), m.position.machine[a]));
  return {};
}

/// G29 (spec/fanuc 6.6): moves at rapid through the intermediate point of the last G28 to the given point.
Status reference_leave(Emitter& m, const Call& call) {
  KADR_TRY(outside_cycles(m, call));
  KADR_TRY(off_surfaces(m, call));
  if (!m.has_axis_words()) return {};
  AxisMask named = 0;
  Axes to;
  KADR_TRY(point_of(m, to, named));
  if (fanuc_of(m).state.has_through) {
    Axes through = m.position.programmed;
    for (std::size_t a = 0; a < m.axis_count; ++a)
      if ((named >> a & 1U) != 0) through[a] = fanuc_of(m).state.through[a];
    KADR_TRY(m.straight(MotionKind::rapid, through, named));
  }
  return m.straight(MotionKind::rapid, to, named);
}

/// G60 (spec/fanuc 3.5): positions from one side; acts as G0 for one block. INFERRED: the motion beyond the end point and back, which the
/// real control adds, is not emitted.
Status single_direction(Emitter& m, const Call&) {
  AxisMask named = 0;
  Axes to;
  KADR_TRY(m.target(to, named));
  return named == 0 ? Status() : m.straight(MotionKind::rapid, to, named);
}

}  // namespace kadr::functions
