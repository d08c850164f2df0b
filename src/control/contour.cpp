#include "control/contour.h"

#include <cmath>

#include "base/tolerance.h"

namespace kadr {
namespace {

Vec2 in_plane(const Machinery& m, const Axes& axes) { return {axes[m.modal.axes.first], axes[m.modal.axes.second]}; }
AxisMask plane_mask(const Machinery& m) { return AxisMask{1} << m.modal.axes.first | AxisMask{1} << m.modal.axes.second; }

/// G41 or G42 have come, the second block of the contour has not.
bool only_begun(const Machinery& m) { return m.modal.contour == ContourPhase::on || m.modal.contour == ContourPhase::approached; }

bool is_contour(MotionKind kind) { return kind == MotionKind::rapid || kind == MotionKind::feed || is_arc(kind); }

/// The motion that G40 has been waiting for, or one that leaves the tool where it stands in the plane.
void lead_off(Machinery& m, Motion& motion, bool in_plane) {
  Modal& modal = m.modal;
  motion.side = modal.contour_side;
  if (!in_plane) return;
  if (is_contour(motion.kind)) {
    motion.side = 0;
    motion.side_step = SideStep::ends;
  }
  modal.contour = ContourPhase::off;
  modal.contour_side = 0;
}

}  // namespace

void begin_contour(Machinery& m, std::int8_t side) {
  Modal& modal = m.modal;
  modal.radius_side = side;
  if (modal.contour == ContourPhase::off) modal.contour = ContourPhase::on;
  if (modal.contour == ContourPhase::leaving) modal.contour = ContourPhase::following;
}

Status end_contour(Machinery& m, const Call& call) {
  Modal& modal = m.modal;
  if (modal.contour == ContourPhase::approached && m.def.behaviour.contour_blocks_checked)
    return fail(alarm(AlarmId::compensation_two_blocks, call.where));
  modal.radius_side = 0;
  modal.radius_by_word = -1;
  modal.contour = modal.contour_side != 0 ? ContourPhase::leaving : ContourPhase::off;
  return {};
}

Status contour_allows_infeed(const Machinery& m, Span where) {
  if (!m.def.behaviour.contour_blocks_checked || !only_begun(m)) return {};
  if (m.has_code({Function::radius_comp_left, Function::radius_comp_right})) return {};
  return fail(alarm(AlarmId::compensation_two_blocks, where));
}

Status contour_allows_motion(const Machinery& m) {
  if (m.nct || !m.def.behaviour.contour_blocks_checked || m.modal.contour == ContourPhase::off || !m.has_axis_words()) return {};
  Axes to;
  AxisMask named = 0;
  KADR_TRY(m.target(to, named));
  if ((named & plane_mask(m)) == 0) return contour_allows_infeed(m, m.block->where);
  const bool cancels = m.modal.contour == ContourPhase::leaving && m.has_code({Function::compensation_off});
  if (!cancels || length(in_plane(m, to) - m.modal.contour_start) > tol::same_point) return {};
  if (length(in_plane(m, to) - in_plane(m, m.position.programmed)) <= tol::same_point) return {};  // it has been closed before
  return fail(alarm(AlarmId::compensation_closing, m.block->where));
}

Status arc_beside_contour(const Machinery& m, Span where, std::string_view code) {
  if (m.modal.contour == ContourPhase::leaving) return fail(alarm(AlarmId::compensation_ends_in_arc, where));
  if (m.modal.contour == ContourPhase::on && m.radius_in_force() != 0) return fail(alarm(AlarmId::compensation_begins_in_arc, where, code));
  return {};
}

void note_contour(Machinery& m, Motion& motion, const Axes& from) {
  Modal& modal = m.modal;
  const bool named = (motion.named & plane_mask(m)) != 0;
  motion.entry = m.def.behaviour.contour_entry_tangent ? ContourEntry::tangent : ContourEntry::normal;
  motion.join_corner = modal.corner_join;
  if (modal.contour == ContourPhase::leaving) return lead_off(m, motion, named);
  const bool moves = named && (is_arc(motion.kind) || length(in_plane(m, motion.to) - in_plane(m, from)) > tol::same_point);
  if (modal.contour == ContourPhase::on && !moves) return;
  const double radius = m.radius_in_force();
  if (modal.radius_by_word < 0 && modal.offset_number != 0) m.use.note(UseKind::radius, modal.offset_number, m.origin, radius == 0);
  if (radius != 0 || modal.contour_side != 0) {  // with a radius of 0 the path is the contour, nothing is held back
    const double side = -modal.radius_side * (radius < 0 ? -1 : 1) * (m.transform.reverses(modal.axes) ? -1 : 1);
    motion.side = modal.contour_side = static_cast<std::int8_t>(side);
    motion.tool_radius = std::fabs(radius);
  }
  if (!moves) return;
  if (modal.contour == ContourPhase::on) {
    if (motion.side != 0) motion.side_step = SideStep::begins;
    modal.contour = ContourPhase::approached;
    modal.contour_start = in_plane(m, m.position.programmed);
  } else {
    modal.contour = ContourPhase::following;
  }
}

}  // namespace kadr
