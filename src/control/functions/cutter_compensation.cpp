// Cutter compensation in the interpreter, for the controls other than NCT: the order of the blocks around G41, G42, G40, and the data that
// each motion carries for the room path. 2С42 6.4.7, 6.6.7, 6.8. Used by the rest of control.

#include "control/functions/cutter_compensation.h"

#include <cmath>

#include "base/tolerance.h"

namespace kadr {
namespace {

Vec2 in_plane(const BlockContext& m, const Axes& axes) { return {axes[m.modal.axes.first], axes[m.modal.axes.second]}; }
AxisMask mask_of(PlaneAxes plane) { return AxisMask{1} << plane.first | AxisMask{1} << plane.second; }
AxisMask plane_mask(const BlockContext& m) { return mask_of(m.modal.axes); }

/// Returns true from G41 or G42 on until the second block of the contour.
bool only_begun(const BlockContext& m) {
  return m.modal.contour == CompensationPhase::on || m.modal.contour == CompensationPhase::approached;
}

bool is_contour(MotionKind kind) { return kind == MotionKind::rapid || kind == MotionKind::feed || is_arc(kind); }

double offset_length(const Modal& modal) { return modal.compensation_side == 0 ? 0 : length(modal.compensation_vector); }

/// Warns, once per contour, of a motion along another axis after G40 while the tool is still offset from the contour. A drilled hole or a
/// step at this position is rarely intended. In the block with G40 of the 2С42 Z gives no warning, because this Z is a word of G40 (6.4.7).
void warn_off_contour(Emitter& m, const Motion& motion, const Axes& from) {
  if (m.modal.off_contour_reported || offset_length(m.modal) <= tol::same_point || !is_contour(motion.kind)) return;
  if (m.has_code({Function::compensation_off})) return;
  bool moves = false;
  for (std::size_t a = 0; a < m.axis_count; ++a) moves = moves || std::fabs(motion.to[a] - from[a]) > tol::same_point;
  if (!moves) return;
  m.modal.off_contour_reported = true;
  m.warn(warning(AlarmId::beside_contour, m.block->where, offset_length(m.modal)));
}

/// Handles the first motion after G40. If it moves in the plane of the contour, the tool leaves the contour. If not, the tool stays offset
/// from the contour. A plane that is selected after G40 has no influence.
void leave_contour(Emitter& m, Motion& motion, const Axes& from) {
  Modal& modal = m.modal;
  motion.side = modal.compensation_side;
  motion.first = static_cast<std::uint8_t>(modal.compensation_axes.first);
  motion.second = static_cast<std::uint8_t>(modal.compensation_axes.second);
  if ((motion.named & mask_of(modal.compensation_axes)) == 0) return warn_off_contour(m, motion, from);
  if (is_contour(motion.kind)) {
    motion.side = 0;
    motion.side_step = SideStep::ends;
  }
  modal.contour = CompensationPhase::off;
  modal.compensation_side = 0;
}

/// Returns the vector from the end of a straight motion to the tool centre. The vector is normal to the motion. At the first motion in
/// RS274/NGC the vector is normal to the path of the tool centre; this path is tangent to the circle with the tool radius around the end
/// point.
Vec2 vector_at_end(const Motion& motion, Vec2 delta) {
  const double distance = length(delta), radius = motion.tool_radius;
  const Vec2 ahead = 1 / distance * delta, left{-ahead.y, ahead.x};
  if (motion.side_step != SideStep::begins || motion.entry != CompensationApproach::tangent || distance <= radius)
    return motion.side * radius * left;
  const double across = radius / distance, along = std::sqrt((1 - across) * (1 + across));
  return motion.side * radius * (along * left - motion.side * across * ahead);
}

/// Records the direction in which the tool is offset at the end of a motion of the contour, if the motion moves in the plane. For an arc,
/// note_arc_end() does so when the centre of the arc is known.
///   delta  travel in the plane, mm
void note_line_end(BlockContext& m, const Motion& motion, Vec2 delta) {
  const bool moves = m.def.behaviour.queues_compensation() ? !(delta == Vec2{}) : length(delta) > tol::same_point;
  if (!is_arc(motion.kind) && moves) m.modal.compensation_vector = vector_at_end(motion, delta);
}

/// Handles a motion on a control that queues compensated motions (LinuxCNC). A motion along any axis starts or continues the contour. A
/// motion after G40 moves straight to its programmed end point (spec/linuxcnc 7.5).
void note_queued(BlockContext& m, Motion& motion, const Axes& from) {
  Modal& modal = m.modal;
  if (modal.contour == CompensationPhase::leaving) return void(modal.contour = CompensationPhase::off);
  const double radius = m.radius_in_force();
  if (radius == 0) return;
  const bool mirrored = (radius < 0) != m.transform.reverses(modal.axes);
  motion.side = static_cast<std::int8_t>(mirrored ? modal.radius_side : -modal.radius_side);
  motion.tool_radius = std::fabs(radius);
  motion.nose = modal.nose;
  if (modal.contour == CompensationPhase::on) motion.side_step = SideStep::begins;
  modal.contour = CompensationPhase::following;
  modal.compensation_axes = modal.axes;
  note_line_end(m, motion, in_plane(m, motion.to) - in_plane(m, from));
}

}  // namespace

bool compensates(const Modal& modal) { return modal.contour != CompensationPhase::off && modal.contour != CompensationPhase::leaving; }

Status begin_compensation(BlockContext& m, const Call& call, std::int8_t side) {
  Modal& modal = m.modal;
  const bool queued = m.def.behaviour.queues_compensation();
  if (modal.contour == CompensationPhase::leaving && !queued &&
      mask_of(modal.compensation_axes) != plane_mask(m))  // the tool is still offset from a contour in another plane
    return fail(alarm(AlarmId::compensation_active, call.where, call.row->code));
  modal.radius_side = side;
  modal.off_contour_reported = false;
  if (modal.contour == CompensationPhase::off || queued) modal.contour = CompensationPhase::on;
  if (modal.contour == CompensationPhase::leaving) modal.contour = CompensationPhase::following;
  return {};
}

void restart_contour_at_tool(Emitter& m) {
  Modal& modal = m.modal;
  if (modal.contour != CompensationPhase::leaving) return;
  const double vector[] = {modal.compensation_vector.x, modal.compensation_vector.y};
  const std::size_t axes[] = {modal.compensation_axes.first, modal.compensation_axes.second};
  for (std::size_t i = 0; i < 2 && modal.compensation_side != 0; ++i) {
    m.position.work[axes[i]] += vector[i];
    m.position.machine[axes[i]] += vector[i];
  }
  m.position.programmed = m.transform.to_programmed(m.position.work);
  m.emit(CompensationBreak{false, true});
  modal.contour = CompensationPhase::off;
  modal.compensation_side = 0;
}

void note_arc_end(BlockContext& m, const Motion& arc) {
  if (m.modal.contour != CompensationPhase::following || arc.side == 0) return;
  const Vec2 arm = in_plane(m, arc.to) - arc.center;
  // The centre of a counter-clockwise arc is on the left, that of a clockwise arc on the right.
  const double toward = (arc.kind == MotionKind::arc_ccw ? -1 : 1) * arc.side;
  if (length(arm) > 0) m.modal.compensation_vector = toward * arc.tool_radius / length(arm) * arm;
}

Status end_contour(Emitter& m, const Call& call) {
  Modal& modal = m.modal;
  if (modal.contour == CompensationPhase::approached && m.def.gives(AlarmId::compensation_two_blocks))
    return fail(alarm(AlarmId::compensation_two_blocks, call.where));
  modal.radius_side = 0;
  modal.radius_by_word = -1;
  if (m.def.behaviour.queues_compensation()) {
    if (modal.contour == CompensationPhase::following) m.emit(CompensationBreak{true});
    if (modal.contour != CompensationPhase::leaving)
      modal.contour = modal.contour == CompensationPhase::following ? CompensationPhase::leaving : CompensationPhase::off;
    return {};
  }
  modal.contour = modal.compensation_side != 0 ? CompensationPhase::leaving : CompensationPhase::off;
  return {};
}

void stop_off_contour(Emitter& m) {
  if (m.def.behaviour.queues_compensation() && m.modal.contour == CompensationPhase::following) m.emit(CompensationBreak{});
}

bool moves_without_words(const BlockContext& m) {
  if (!m.def.behaviour.queues_compensation() || m.modal.contour == CompensationPhase::off) return false;
  return m.modal.contour == CompensationPhase::leaving || m.radius_in_force() != 0;
}

Status contour_allows_infeed(const BlockContext& m, Span where) {
  if (!only_begun(m) || !m.def.gives(AlarmId::compensation_two_blocks)) return {};
  if (m.has_code({Function::radius_comp_left, Function::radius_comp_right})) return {};
  return fail(alarm(AlarmId::compensation_two_blocks, where));
}

Status contour_allows_motion(const BlockContext& m) {
  if (m.modal.contour == CompensationPhase::off || !m.has_axis_words() || !m.def.gives(AlarmId::compensation_two_blocks)) return {};
  Axes to;
  AxisMask named = 0;
  KADR_TRY(m.target(to, named));
  if ((named & plane_mask(m)) == 0) return contour_allows_infeed(m, m.block->where);
  const bool cancels = m.modal.contour == CompensationPhase::leaving && m.has_code({Function::compensation_off});
  if (!cancels || length(in_plane(m, to) - m.modal.compensation_start) > tol::same_point) return {};
  // The contour was closed by an earlier block, so this block may have G40.
  if (length(in_plane(m, to) - in_plane(m, m.position.programmed)) <= tol::same_point) return {};
  return fail(alarm(AlarmId::compensation_closing, m.block->where));
}

Status check_arc_at_compensation_ends(const BlockContext& m, Span where, std::string_view code) {
  if (m.modal.contour == CompensationPhase::leaving) return fail(alarm(AlarmId::compensation_ends_in_arc, where));
  if (m.modal.contour == CompensationPhase::on && m.radius_in_force() != 0)
    return fail(alarm(AlarmId::compensation_begins_in_arc, where, code));
  return {};
}

void note_compensation(Emitter& m, Motion& motion, const Axes& from) {
  if (m.def.behaviour.queues_compensation()) return note_queued(m, motion, from);
  Modal& modal = m.modal;
  const bool named = (motion.named & plane_mask(m)) != 0;
  motion.entry =
      m.def.behaviour.compensation_entry == CompensationEntry::tangent ? CompensationApproach::tangent : CompensationApproach::normal;
  motion.join_corner = modal.corner_join;
  if (modal.contour == CompensationPhase::leaving) return leave_contour(m, motion, from);
  const bool moves = named && (is_arc(motion.kind) || length(in_plane(m, motion.to) - in_plane(m, from)) > tol::same_point);
  if (modal.contour == CompensationPhase::on && !moves) return;
  const double radius = m.radius_in_force();
  if (modal.radius_by_word < 0 && modal.offset_number != 0) m.use.note(UseKind::radius, modal.offset_number, m.origin, radius == 0);
  if (radius != 0 || modal.compensation_side != 0) {  // with radius 0 the tool centre moves along the contour itself
    const double side = -modal.radius_side * (radius < 0 ? -1 : 1) * (m.transform.reverses(modal.axes) ? -1 : 1);
    motion.side = modal.compensation_side = static_cast<std::int8_t>(side);
    motion.tool_radius = std::fabs(radius);
  }
  if (!moves) return;
  modal.compensation_axes = modal.axes;
  const bool begins = modal.contour == CompensationPhase::on;
  if (begins) {
    if (motion.side != 0) motion.side_step = SideStep::begins;
    modal.contour = CompensationPhase::approached;
    modal.compensation_start = in_plane(m, m.position.programmed);
  } else {
    modal.contour = CompensationPhase::following;
  }
  note_line_end(m, motion, in_plane(m, motion.to) - in_plane(m, from));
}

bool continues_contour(const Modal& modal) {
  return modal.radius_side != 0 && modal.contour == CompensationPhase::following && modal.compensation_axes == modal.axes;
}

void continue_contour(BlockContext& m, const Motion& motion, Vec2 from) {
  if (m.modal.contour != CompensationPhase::following) return;
  if (is_arc(motion.kind)) note_arc_end(m, motion);
  else note_line_end(m, motion, in_plane(m, motion.to) - from);
}

}  // namespace kadr
