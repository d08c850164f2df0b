// Work systems and shifts, plane selection: G54 … G59, G54.1, G52, G92, G53, G10.9, G17–G19 (spec/nct/09, 10).

#include <cmath>

#include "control/fanuc/fanuc.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"

namespace kadr {
namespace {

/// Checks that neither polar nor cylindrical interpolation is on (4.5, 4.6).
Status plane_surface(const BlockContext& m, const Call& call) {
  if (m.modal.surface != PathSurface::plane) return fail(alarm(AlarmId::surface_state, call.where, call.row->code));
  return {};
}

/// Calls `use(axis, value, word)` for each axis word; `use` returns a Status. `value` is the number as written, in mm or degrees; for an
/// axis in diameter programming it is halved.
template <class Use>
Status each_axis(const BlockContext& m, Use use) {
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address == 0 || (m.letters.axes & letter_bit(w.address)) == 0) continue;
    const AddressRow& row = m.def.address(w.address);
    double v = w.value * (row.unit == WordUnit::length ? m.unit_scale() : 1.0);
    if ((m.modal.diameter >> row.axis & 1u) != 0) v /= 2;
    KADR_TRY(use(std::size_t{row.axis}, v, w));
  }
  return {};
}

bool written_as_increment(const BlockContext& m, const Word& w) {
  return w.incremental || m.def.address(w.address).function == Function::increment_axis;
}

/// Returns the axis of the plane for a direction `d` (1 X, 2 Y, 3 Z): the main axis, unless the block names an axis of this direction. A
/// named main axis has priority over a named parallel axis (10.4).
int axis_of_direction(const BlockContext& m, int d) {
  int parallel = -1;
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    if ((fanuc_of(m).plane_axes >> a & 1u) == 0) continue;
    const int role = fanuc_of(m).settings.axes[a].role;
    if (role == d) return static_cast<int>(a);
    if (role == d + 4) parallel = static_cast<int>(a);
  }
  return parallel >= 0 ? parallel : fanuc::main_axis(m, d);
}

bool names_direction(const BlockContext& m, int d) {
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if ((fanuc_of(m).plane_axes >> a & 1u) != 0 && (fanuc_of(m).settings.axes[a].role == d || fanuc_of(m).settings.axes[a].role == d + 4))
      return true;
  return false;
}

/// Returns the rotary axis that a block with G17, G18 or G19 names, or -1. It replaces an axis of the plane: if the block also names the
/// other axis of the plane, that axis stays (4.5, 4.6).
int named_rotary(const BlockContext& m) {
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if ((fanuc_of(m).plane_axes >> a & 1u) != 0 && (m.def.rotary >> a & 1u) != 0) return static_cast<int>(a);
  return -1;
}

}  // namespace

namespace functions {

Status select_plane(Emitter& m, const Call& call) {
  KADR_TRY(plane_surface(m, call));
  const Plane plane = call.row->arg == 18 ? Plane::zx : call.row->arg == 19 ? Plane::yz : Plane::xy;
  const auto [d1, d2, d3] = plane == Plane::zx ? std::array{3, 1, 2} : plane == Plane::yz ? std::array{2, 3, 1} : std::array{1, 2, 3};
  int first = axis_of_direction(m, d1), second = axis_of_direction(m, d2);
  const bool names_first = names_direction(m, d1), names_second = names_direction(m, d2);
  if (const int rotary = named_rotary(m); rotary >= 0 && names_first != names_second) (names_first ? second : first) = rotary;
  const int normal = fanuc::main_axis(m, d3);
  if (m.modal.radius_side != 0 && (m.modal.plane != plane)) return fail(alarm(AlarmId::compensation_active, call.where, call.row->code));
  m.modal.plane = plane;
  // A channel that lacks an axis of the plane can still select the plane; only a motion in the plane raises an alarm.
  m.modal.axes = {static_cast<std::size_t>(std::max(first, 0)), static_cast<std::size_t>(std::max(second, 0)),
                  static_cast<std::size_t>(std::max(normal, 0))};
  return {};
}

/// G54 … G59 (10.2.1): selects a work system.
Status work_system(Emitter& m, const Call& call) {
  KADR_TRY(plane_surface(m, call));
  // G54 P3 selects a further work system (spec/fanuc 6.1).
  const bool extended = call.row->arg == 1 && m.has('P') && (call.row->takes & letter_bit('P')) != 0;
  if (extended) return work_system_extended(m, call);
  m.modal.work_zero = static_cast<std::uint16_t>(call.row->arg);
  note_work_offset(m, m.modal.work_zero);
  m.change_frames();
  return {};
}

/// G54.1 P (10.2.2): selects a further work system: P1 … P99 on the NCT, up to P300 on the Fanuc (spec/fanuc 6.1).
Status work_system_extended(Emitter& m, const Call& call) {
  KADR_TRY(plane_surface(m, call));
  if (!m.has('P')) return fail(alarm(AlarmId::word_missing, call.where, 'P', call.row->code));
  const auto number = m.whole('P', 1, m.def.behaviour.further_systems);
  if (!number) return fail(number.error());
  m.modal.work_zero = static_cast<std::uint16_t>(macro_b::basic_systems + *number);
  note_work_offset(m, m.modal.work_zero);
  m.change_frames();
  return {};
}

/// G52 (10.3): sets the origin of the local system; an increment shifts the present origin.
Status local_system(Emitter& m, const Call& call) {
  KADR_TRY(plane_surface(m, call));
  KADR_TRY(each_axis(m, [&](std::size_t a, double v, const Word& w) -> Status {
    const bool adds = !m.modal.absolute || written_as_increment(m, w);
    m.modal.local[a] = adds ? m.modal.local[a] + v : v;
    return {};
  }));
  m.change_frames();
  return {};
}

/// Ends the shifts of G50 and G52 on the named axes: G50.3, in the systems B and C G92.1 (spec/fanuc-t 5.1).
Status end_new_system(Emitter& m, const Call& call) {
  if (!m.has_axis_words()) return fail(alarm(AlarmId::no_axis_word, call.where, call.row->code));
  KADR_TRY(each_axis(m, [&](std::size_t a, double, const Word&) -> Status {
    m.modal.new_system[a] = m.modal.local[a] = 0;
    return {};
  }));
  m.change_frames();
  return {};
}

/// G92 (10.2.6): gives the tool's position the stated coordinates in every work system, and deletes the shift of G52 on the named axes.
/// Word S limits the spindle speed (11.5.2). On a lathe an increment shifts the systems so that the present coordinate grows by it
/// (spec/fanuc-t 5.1).
Status new_system(Emitter& m, const Call& call) {
  if (call.row->arg == 503) return end_new_system(m, call);
  if (m.has('S')) {
    fanuc_of(m).state.max_css_speed = m.value('S');
    if (m.modal.surface_speed) fanuc_of(m).emit_surface_speed(m);
  }
  if (!m.has_axis_words()) {
    if (m.has('S')) return {};
    return fail(alarm(AlarmId::no_axis_word, call.where, call.row->code));
  }
  KADR_TRY(plane_surface(m, call));
  KADR_TRY(each_axis(m, [&](std::size_t a, double v, const Word& w) -> Status {
    const bool increment = written_as_increment(m, w), lathe = m.def.behaviour.lathe != Lathe::none;
    if (increment && !lathe) return fail(alarm(AlarmId::incremental_in_machine, w.where, std::string_view(m.axis_names[a])));
    // chapter 16: mirroring, scaling and rotation do not act on the coordinates of G92
    const double here = m.position.work[a] + m.modal.local[a];
    const bool adds = lathe && (increment || !m.modal.absolute);
    m.modal.new_system[a] += adds ? -v : here - v;
    m.modal.local[a] = 0;
    return {};
  }));
  m.change_frames();
  return {};
}

/// G53 (10.1.1): moves at rapid to machine coordinates, which are always absolute, without compensations. G53 without axis words empties
/// the look-ahead buffer.
Status machine_move(Emitter& m, const Call& call) {
  macro_b_of(m).stops_reading = true;
  if (!m.has_axis_words()) return {};
  if (m.def.behaviour.machine_move_absolute && !m.modal.absolute) {  // spec/fanuc 6.5: G53 does nothing while G91 is in force
    m.warn(warning(AlarmId::machine_move_incremental, call.where, call.row->code));
    return {};
  }
  KADR_TRY(plane_surface(m, call));
  Axes to = m.position.machine;
  AxisMask named = 0;
  fanuc_of(m).rolled = 0;
  KADR_TRY(each_axis(m, [&](std::size_t a, double v, const Word& w) -> Status {
    if (written_as_increment(m, w) && m.def.behaviour.lathe != Lathe::none) {  // spec/fanuc-t 5.4: U and W are ignored
      m.warn(warning(AlarmId::machine_move_incremental, w.where, w.written));
      return {};
    }
    if (written_as_increment(m, w)) return fail(alarm(AlarmId::incremental_in_machine, w.where, std::string_view(m.axis_names[a])));
    to[m.frames.driven(a)] = v;
    named |= 1u << a;
    // In G53 a rotary axis that rolls over turns in the direction in which it turns with G90 (5.6).
    if (const fanuc::AxisSettings& axis = fanuc_of(m).settings.axes[a]; axis.rolls && (m.def.rotary >> a & 1u) != 0) {
      const double from = fanuc::rolled_position(m.position.machine[a], axis.period);
      fanuc_of(m).travel[a] = fanuc::roll_travel(axis, from, v, false);
      fanuc_of(m).rolled |= 1u << a;
      to[a] = from + fanuc_of(m).travel[a];
    }
    if (!(std::fabs(v) <= farthest)) return fail(alarm(AlarmId::position_out_of_range, w.where, w.address, v));
    return {};
  }));
  KADR_TRY(m.to_machine(MotionKind::rapid, to, named, 0));
  macro_b_of(m).moved = false;
  return {};
}

/// G10.9 (5.3.1): switches axes to radius (0) or diameter (1) programming; nothing moves. G171 and G172 of a lathe switch X to radius or
/// diameter programming (spec/haas-st 1).
Status diameter_switch(Emitter& m, const Call& call) {
  if (call.row->arg != 0) {
    const int x = fanuc::main_axis(m, 1);
    const std::uint32_t mask = x < 0 ? 0U : 1U << static_cast<unsigned>(x);
    m.modal.diameter = call.row->arg == 172 ? m.modal.diameter | mask : m.modal.diameter & ~mask;
    return {};
  }
  if (!m.has_axis_words()) return fail(alarm(AlarmId::no_axis_word, call.where, call.row->code));
  return each_axis(m, [&](std::size_t a, double, const Word& w) -> Status {
    const bool linear = (m.def.rotary >> a & 1u) == 0;
    if (!linear || written_as_increment(m, w)) return fail(alarm(AlarmId::illegal_address, w.where, w.written));
    if (w.value != 0 && w.value != 1) return fail(alarm(AlarmId::value_out_of_range, w.where, w.address, w.value));
    if (!fanuc_of(m).settings.axes[a].switches_by_code)
      return fail(alarm(AlarmId::diameter_by_machine, w.where, std::string_view(m.axis_names[a])));
    if (w.value == 1) m.modal.diameter |= 1u << a;
    else m.modal.diameter &= ~(1u << a);
    return {};
  });
}

}  // namespace functions
}  // namespace kadr
