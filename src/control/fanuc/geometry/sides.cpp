// Adds to motions and blocks the data that cutter radius compensation needs (path/compensation/radius_compensation; spec/nct/15 15.5). Used
// by the rest of control.

#include "control/fanuc/geometry/sides.h"

#include <cmath>

#include "control/emitter.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/words/coordinates.h"

namespace kadr::fanuc {

void note_side(BlockContext& m, Motion& motion) {
  UndoableState& state = fanuc_of(m).state;
  if (m.modal.radius_side == 0 && state.side_step != SideStep::ends) return;
  const bool arc = motion.kind == MotionKind::arc_cw || motion.kind == MotionKind::arc_ccw;
  const bool contour = arc || motion.kind == MotionKind::rapid || motion.kind == MotionKind::feed;
  if (!contour || m.modal.surface != PathSurface::plane || fanuc_of(m).uncompensated) return;
  const PlaneAxes& plane = m.modal.axes;
  const int side = (state.tool_radius < 0) == m.transform.reverses(plane) ? -m.modal.radius_side : m.modal.radius_side;
  motion.side = static_cast<std::int8_t>(side);
  motion.tool_radius = std::fabs(state.tool_radius);
  motion.nose = state.nose;
  motion.entry = fanuc_of(m).settings.approach;
  if (m.modal.offset_number != 0) m.use.note(UseKind::radius, m.modal.offset_number, m.origin, state.tool_radius == 0);
  if ((m.transform.moved_with(motion.named) & (AxisMask{1} << plane.first | AxisMask{1} << plane.second)) == 0) return;
  motion.side_step = state.side_step;
  if (fanuc_of(m).holds_vector && motion.side_step == SideStep::none) motion.side_step = SideStep::holds;
  state.compensates = motion.side_step != SideStep::ends;
  if (motion.side_step != SideStep::none && state.direction_vector) detail_of(m, motion).direction_vector = state.direction_vector;
  state.side_step = SideStep::none;
  state.direction_vector.reset();
}

void note_skip_mark(Emitter& m) {
  if (fanuc_of(m).state.compensates && fanuc_of(m).settings.skip_breaks_compensation) m.emit(CompensationBreak{});
}

void end_side_block(Emitter& m) {
  UndoableState& state = fanuc_of(m).state;
  // On a lathe, G41 or G42 without a motion starts compensation in the next motion (spec/fanuc-t 7.3, INFERRED).
  if (state.side_step == SideStep::begins && !fanuc_of(m).settings.compensates_nose) state.side_step = SideStep::begun;
  if (state.side_step != SideStep::ends) return;
  m.emit(CompensationBreak{true});
  state.side_step = SideStep::none;
  state.compensates = false;
  state.direction_vector.reset();
}

void restart_side(Emitter& m) {
  UndoableState& state = fanuc_of(m).state;
  if (m.modal.radius_side == 0) return;
  if (state.compensates) m.emit(CompensationBreak{});
  state.compensates = false;
  state.side_step = SideStep::begins;
}

void suspend_side(Emitter& m) {
  restart_side(m);
  fanuc_of(m).uncompensated = fanuc_of(m).uncompensated || m.modal.radius_side != 0;
}

std::optional<Vec2> plane_direction(const BlockContext& m) {
  constexpr char letters[] = {'I', 'J', 'K'};
  constexpr std::array<std::array<std::size_t, 2>, 3> of_plane{{{0, 1}, {2, 0}, {1, 2}}};
  const auto& pair = of_plane[m.modal.plane == Plane::xy ? 0 : m.modal.plane == Plane::zx ? 1 : 2];
  const char first = letters[pair[0]], second = letters[pair[1]];
  if (!m.has(first) && !m.has(second)) return std::nullopt;
  const Vec2 direction = m.transform.direction({m.length_value(first), m.length_value(second)}, m.modal.axes);
  return direction == Vec2{} ? std::nullopt : std::optional(direction);
}

}  // namespace kadr::fanuc
