// Frames, lengths, planes. The position chain (spec/nct/10): machine position = C + W + M·(S + Lc + p), where C is the common offset, W
// the work offset, M the basic rotation, S the shift of G92, Lc the shift of G52, p the programmed position.

#include <cmath>

#include "base/units.h"
#include "control/emitter.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/five_axis/five_axis_functions.h"
#include "control/fanuc/geometry/sides.h"
#include "control/fanuc/words/coordinates.h"

namespace kadr::fanuc {
namespace {

/// Returns the basic rotation of a work system as a matrix: M_Z(gamma)·M_Y(beta)·M_X(alpha) (10.2.3).
std::array<Vec3, 3> rotation_rows(Vec3 angles) {
  const SinCos g = sincos_deg(angles.x), b = sincos_deg(angles.y), a = sincos_deg(angles.z);
  return {Vec3{g.cos * b.cos, g.cos * b.sin * a.sin - g.sin * a.cos, g.cos * b.sin * a.cos + g.sin * a.sin},
          Vec3{g.sin * b.cos, g.sin * b.sin * a.sin + g.cos * a.cos, g.sin * b.sin * a.cos - g.cos * a.sin},
          Vec3{-b.sin, b.cos * a.sin, b.cos * a.cos}};
}

std::shared_ptr<const FrameTurn> rotation_of(const BlockContext& m, const std::shared_ptr<const FrameTurn>& before) {
  const Vec3 angles = m.tables.rotations[m.modal.work_zero];
  const AxisDrives& drives = fanuc_of(m).driven;
  if (angles == Vec3{} && drives.is_own) return nullptr;
  FrameTurn rotation;
  rotation.drives = drives;
  if (angles != Vec3{}) rotation.rows = rotation_rows(angles);
  for (int role = 1; role <= 3; ++role) rotation.main[static_cast<std::size_t>(role - 1)] = static_cast<std::int8_t>(main_axis(m, role));
  if (before && *before == rotation) return before;
  return std::make_shared<const FrameTurn>(rotation);
}

}  // namespace

int main_axis(const BlockContext& m, int role) {
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if (fanuc_of(m).settings.axes[a].role == role) return static_cast<int>(a);
  return -1;
}

std::string plane_name(const BlockContext& m) { return m.axis_names[m.modal.axes.first] + m.axis_names[m.modal.axes.second]; }

namespace {

void refresh_sums(BlockContext& m) {
  Placement& f = m.frames;
  f.turn = rotation_of(m, f.turn);
  // 25d. INFERRED: while a dynamic offset is in force, the common work offset is not added
  const bool dynamic = m.modal.work_zero >= all_systems;
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    f.origin[a] = (dynamic ? 0 : m.tables.common[a]) + m.tables.zeros[m.modal.work_zero][a];
    f.shift[a] = m.modal.new_system[a] + m.modal.local[a];
    f.length[a] = m.modal.lengths[a];
  }
  // spec/fanuc-t 11.3
  if (const int x = main_axis(m, 1); fanuc_of(m).state.second_turret && x >= 0)
    f.origin[static_cast<std::size_t>(x)] += fanuc_of(m).settings.lathe.turret_distance;
  if (f.turn == nullptr) {
    for (std::size_t a = 0; a < m.axis_count; ++a) f.origin[a] += f.shift[a];
    f.shift = {};
    return;
  }
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    bool is_main = false;
    for (const std::int8_t main : f.turn->main) is_main = is_main || main == static_cast<std::int8_t>(a);
    if (is_main) continue;
    f.origin[a] += f.shift[a];
    f.shift[a] = 0;
  }
}

}  // namespace

void refresh_frames(Emitter& m) {
  const std::shared_ptr<const FrameTurn> before = m.frames.turn;
  refresh_sums(m);
  refresh_space(m);
  if (before && m.frames.turn && *before == *m.frames.turn) m.frames.turn = before;
}

/// Returns the shift of G52 and G92. If the work system is rotated, returns 0: Placement::shift then contains the shift, so that the shift
/// is rotated too.
Axes shift_of_origin(const BlockContext& m) {
  Axes shift{};
  for (std::size_t a = 0; a < m.axis_count && m.frames.turn == nullptr; ++a) shift[a] = m.modal.new_system[a] + m.modal.local[a];
  return shift;
}

MotionDetail& detail_of(BlockContext& m, Motion& motion) {
  (void)m;
  auto detail = motion.detail ? std::make_shared<MotionDetail>(*motion.detail) : std::make_shared<MotionDetail>();
  MotionDetail& filled = *detail;
  motion.detail = std::move(detail);
  return filled;
}

/// Reduces positions of axes that roll over to [0, period), so that full revolutions are dropped (5.6).
void roll_positions(const BlockContext& m, Axes& positions) {
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    const AxisSettings& axis = fanuc_of(m).settings.axes[a];
    if (axis.rolls && (m.def.rotary >> a & 1u) != 0) positions[a] = rolled_position(positions[a], axis.period);
  }
}

double inch_feed(const BlockContext& m, const Motion& motion, const Axes& from) {
  double linear = 0, rotary = 0;  // sums of the squared travels: of the linear axes in mm², of the rotary axes in degrees²
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    const bool rolls = motion.detail && (motion.detail->rolled >> a & 1u) != 0;
    const double travel = rolls ? motion.detail->travel[a] : motion.to[a] - from[a];
    ((m.def.rotary >> a & 1u) != 0 ? rotary : linear) += travel * travel;
  }
  if (rotary == 0 || m.modal.surface != PathSurface::plane || controls_tip(fanuc_of(m).state.five_axis.tip_control)) return m.modal.feed;
  const double feed = m.modal.feed / mm_per_inch;  // programmed feed in inches per minute, or for rotary axes in degrees per minute
  return feed * std::sqrt((linear + rotary) / (linear / (mm_per_inch * mm_per_inch) + rotary));
}

namespace {

/// Returns the smoothing mode of a motion. Fine smoothing acts only on G1, with G40, G64 and G80 in force (4.7).
std::uint8_t smoothing_of(const BlockContext& m, const Motion& motion) {
  const AxisMask smoothed =
      fanuc_of(m).state.smoothed != 0 ? fanuc_of(m).state.smoothed : ((AxisMask{1} << m.axis_count) - 1) & ~m.def.rotary;
  const bool alone = m.modal.radius_side == 0 && m.modal.surface == PathSurface::plane && m.modal.motion == MotionMode::linear;
  const bool continues = motion.corner_speed == CornerSpeed::limited && (motion.named & ~smoothed) == 0;
  return motion.kind == MotionKind::feed && alone && continues ? m.modal.smoothing : std::uint8_t{0};
}

/// Adds the programmed end point to a motion in a programming frame in space. Reports show this point together with the end point after
/// transformations and compensation.
void add_programmed_end(BlockContext& m, Motion& motion) {
  MotionDetail& detail = detail_of(m, motion);
  detail.programmed = m.position.programmed;
  detail.has_programmed = true;
}

/// Warns once of a cut with feed per revolution while every spindle stands: the axes of a lathe wait then (spec/fanuc-t 3.7, U). INFERRED:
/// after a code of the machine no warning is possible, because the code may have started a live tool.
void watch_turns(Emitter& m, const Motion& motion) {
  Fanuc& fanuc = fanuc_of(m);
  if (fanuc.standing_reported || fanuc.reads_figure || m.modal.feed_mode != FeedMode::per_revolution) return;
  if (motion.kind != MotionKind::feed && motion.kind != MotionKind::arc_cw && motion.kind != MotionKind::arc_ccw) return;
  if (fanuc.state.machine_may_turn) return;
  for (const SpindleState& spindle : fanuc.state.spindles)
    if ((spindle.dir == SpindleDir::cw || spindle.dir == SpindleDir::ccw) && (spindle.rpm > 0 || m.modal.surface_speed)) return;
  fanuc.standing_reported = true;
  m.warn(warning(AlarmId::feed_without_turns, m.block->where));
}

}  // namespace

void note_motion(Emitter& m, Motion& motion) {
  Fanuc& fanuc = fanuc_of(m);
  fanuc.moved = true;
  if (fanuc.settings.lathe.is_lathe) watch_turns(m, motion);
  const bool plain = m.transform.identity && m.modal.radius_side == 0 && m.modal.surface == PathSurface::plane;
  motion.as_programmed = plain && motion.kind != MotionKind::probe;
  if (!plain && fanuc.state.five_axis.frame != SpaceFrame::none) add_programmed_end(m, motion);
  if (motion.kind != MotionKind::thread) fanuc.state.in_thread = false;
  const bool tip = controls_tip(fanuc.state.five_axis.tip_control);  // 25.14: the programmed feed is the feed of the tool tip
  // 4.2: the feed of a motion of linear and rotary axes counts along a path in which 1 mm and 1 degree are equal
  motion.along = tip ? FeedAlong::path : FeedAlong::all_axes;
  // The bits of #3004 (23.1.10, 6.3.4): M_FHD inhibits feed hold; M_OV inhibits override and feed hold, as G63 does; M_EST inhibits exact
  // stop.
  constexpr std::uint32_t m_fhd = 1, m_ov = 2, m_est = 4;
  if ((fanuc.control_2 & m_est) != 0) motion.exact = false;
  const bool stops = (m.block_exact || m.modal.exact) && (fanuc.control_2 & m_est) == 0;
  motion.in_position = stops || (motion.kind == MotionKind::rapid && fanuc.settings.in_position_check);
  motion.own_override = (fanuc.control_2 & m_ov) != 0 || m.modal.rows[fanuc.stop_group] == fanuc.inhibiting;
  motion.no_hold = motion.own_override || (fanuc.control_2 & m_fhd) != 0;
  if (motion.own_override) motion.corner_speed = CornerSpeed::kept;  // G63 (6.3.4): the motion has the full feed at corners
  else if (m.modal.rows[fanuc.stop_group] == fanuc.slowing) motion.corner_speed = CornerSpeed::inner_slower;
  if (m.modal.smoothing != 0) motion.join = fanuc.settings.accuracy;
  if (m.modal.smoothing > 1 && !stops) motion.smoothing = smoothing_of(m, motion);
  if (fanuc.rolled != 0) {
    MotionDetail& detail = detail_of(m, motion);
    detail.rolled = fanuc.rolled;
    for (std::size_t a = 0; a < m.axis_count; ++a) detail.travel[a] = fanuc.travel[a] * m.transform.mirror[a];
    fanuc.rolled = 0;
    roll_positions(m, m.position.work);
    roll_positions(m, m.position.machine);
    motion.to = m.position.work;
    motion.machine = m.position.machine;
  }
  if (m.modal.radius_side != 0 || fanuc.state.side_step != SideStep::none) note_side(m, motion);
}

}  // namespace kadr::fanuc
