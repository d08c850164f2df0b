// G43.1, G43.4, G43.5, G43.8, G43.9: length compensation in the tool's direction, tool centre point control, cutting point control
// (spec/nct/25b, 25h, 25i, 25j). Used by control/functions, control/fanuc/dialect.

#include <algorithm>
#include <cmath>

#include "base/code_literals.h"
#include "control/fanuc/drilling/drilling.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/five_axis/five_axis_functions.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"
#include "kinematics/five_axis_tip_path.h"
#include "kinematics/five_axis_transform.h"

namespace kadr::fanuc {
namespace {

FiveAxisState& five_of(const BlockContext& m) { return fanuc_of(m).state.five_axis; }

std::string code_of(TipControl tip_control) {
  switch (tip_control) {
    case TipControl::axis: return "G43.1";
    case TipControl::tip: return "G43.4";
    case TipControl::tip_vector: return "G43.5";
    case TipControl::contact: return "G43.8";
    case TipControl::contact_vector: return "G43.9";
    default: return "G49";
  }
}

TipControl tip_control_of(int arg) {
  switch (arg) {
    case 43.1_g: return TipControl::axis;
    case 43.4_g: return TipControl::tip;
    case 43.5_g: return TipControl::tip_vector;
    case 43.8_g: return TipControl::contact;
    default: return TipControl::contact_vector;
  }
}

/// Raises an alarm if a mode is in force that 25.14 does not describe together with tool centre point control. INFERRED: the manual gives
/// no alarm for this case; an alarm is safer than a motion.
Status nothing_else(const BlockContext& m, const Call& call) {
  const FiveAxisState& five = five_of(m);
  const auto refuse = [&](std::string_view what) { return fail(alarm(AlarmId::lead_state, call.where, call.row->code, what)); };
  if (five.frame != SpaceFrame::none) return refuse(five.frame == SpaceFrame::plane ? "G68.2" : "G68.1");
  if (m.modal.work_zero >= all_systems) return refuse("G54.2");
  if (m.modal.radius_side != 0) return refuse(m.modal.radius_side < 0 ? "G41" : "G42");
  if (m.modal.surface != PathSurface::plane) return refuse(m.modal.surface == PathSurface::polar ? "G12.1" : "G7.1");
  if (drilling_on(m)) return refuse("G81");
  if (m.modal.polar_data) return refuse("G16");
  return {};
}

/// Returns true if G0 or G1 is in force or in the block (25.14).
bool straight_mode(const BlockContext& m) {
  if (m.has_code({Function::rapid, Function::linear})) return true;
  if (m.has_code({Function::arc_cw, Function::arc_ccw, Function::thread, Function::drilling})) return false;
  return m.modal.motion == MotionMode::rapid || m.modal.motion == MotionMode::linear;
}

/// Returns the cone on which the tool's direction moves along an arc: the arc's plane and axis, and the angle from start to end (η of
/// 25.16).
DirectionPath::Cone cone_of(const Motion& motion, const FiveAxisTransform& space) {
  const auto& main = space.data().main;
  const auto of = [&](std::size_t axis) {
    for (std::size_t i = 0; i < 3; ++i)
      if (main[i] == static_cast<std::int8_t>(axis)) return Vec3{i == 0 ? 1. : 0., i == 1 ? 1. : 0., i == 2 ? 1. : 0.};
    return Vec3{};
  };
  const Vec3 first = of(motion.first), second = of(motion.second);
  const double sweep = 360 * motion.turns * (motion.kind == MotionKind::arc_cw ? -1 : 1);
  return {first, second, cross(first, second), sweep};
}

}  // namespace

void register_tip_length(BlockContext& m, double length) {
  m.modal.lengths = {};
  five_of(m).tip_length = length;
}

void note_tip_radius(BlockContext& m) {
  FiveAxisState& five = five_of(m);
  if (!controls_contact(five.tip_control)) return;
  const std::uint32_t number = m.modal.offset_number;
  const ToolOffset offset = number < m.tables.offsets.size() ? m.tables.offsets[number] : ToolOffset();
  five.radius = offset.radius + offset.radius_wear;
  five.corner = offset.corner + offset.corner_wear;
}

/// Checks the rule "With G49 only G0 or G1 may be programmed" (25.14), which forbids an arc in the block of G49. A block of G49 without
/// motion ends the mode, whatever motion code is in force.
Status may_end_tip_control(const BlockContext& m, const Call& call) {
  if (!controls_tip(five_of(m).tip_control) || straight_mode(m)) return {};
  const bool arc_named = m.has_code({Function::arc_cw, Function::arc_ccw, Function::thread, Function::drilling});
  const bool moves = m.has_axis_words() || m.has('I') || m.has('J') || m.has('K') || m.has('R');
  if (!arc_named && !moves) return {};
  return fail(alarm(AlarmId::lead_mode, call.where, call.row->code));
}

void end_tip_control(BlockContext& m) {
  FiveAxisState& five = five_of(m);
  five.tip_control = TipControl::none;
  five.posture = false;
  five.tip_length = 0;
  five.normal = {};
  if (m.modal.work_zero < all_systems) five.positioned = 0;
}

void reset_five_axis(BlockContext& m) {
  if (fanuc_of(m).settings.five_axis.group == MachineGroup::none && five_of(m).frame == SpaceFrame::none && five_of(m).plane.kind == 0)
    return;
  five_of(m) = {};
}

bool controls_lines(const BlockContext& m) {
  const FiveAxisState& five = five_of(m);
  if (controls_tip(five.tip_control) && (five.posture || controls_contact(five.tip_control))) return true;
  return fanuc_of(m).settings.tilts_tool && (five.tip_control != TipControl::none || m.modal.work_zero >= all_systems);
}

Status tip_control_line(Emitter& m, const Call& call, MotionKind kind) {
  AxisMask named = 0;
  Axes to;
  KADR_TRY(m.target(to, named));
  if (named == 0) return {};
  if (kind == MotionKind::feed) KADR_TRY(m.feed_known(call.where));
  note_positioned(m, named);
  const Axes from = m.position.work;
  KADR_TRY(m.straight(kind, to, named));
  return control_tip(m, std::get<Motion>(m.batch->back().what), from);
}

/// Completes a motion. Tool posture control keeps the tool's direction in the plane, or on the cone, that contains the directions at both
/// ends of the motion (25.16). Cutting point control places the tip so that the tool touches the programmed point (25.17).
Status control_tip(BlockContext& m, Motion& motion, const Axes& from) {
  const FiveAxisState& five = five_of(m);
  const FiveAxisTransform* const space = space_of(m);
  if (space == nullptr || !controls_tip(five.tip_control) || (!five.posture && !controls_contact(five.tip_control))) return {};
  FiveAxisTipPath::Data data;
  data.space = std::static_pointer_cast<const FiveAxisTransform>(std::static_pointer_cast<const WorkTransform>(m.frames.space));
  data.begins = std::exchange(five_of(m).begins, false);
  data.posture = five.posture && !data.begins;
  data.start = from;
  data.end = motion.to;
  if (motion.detail && motion.detail->rolled != 0)
    for (std::size_t a = 0; a < m.axis_count; ++a)
      if ((motion.detail->rolled >> a & 1u) != 0) data.end[a] = from[a] + motion.detail->travel[a];
  if (is_arc(motion.kind)) data.cone = cone_of(motion, *space);
  if (controls_contact(five.tip_control)) {
    if (five.normal == Vec3{}) return fail(alarm(AlarmId::normal_missing, m.block->where, code_of(five.tip_control)));
    data.contact = true;
    data.radius = five.radius;
    data.corner = five.corner;
    data.normal = fanuc_of(m).normal_before == Vec3{} ? five.normal : fanuc_of(m).normal_before;
    data.end_normal = five.normal;
  }
  auto tip_path = std::make_shared<FiveAxisTipPath>(data);
  if (data.posture) {
    const auto reached = tip_path->end_of_posture();
    const RotaryPair programmed = space->rotary(data.end);
    constexpr double same_angle = 0.01;  // degrees; two positions of an axis that differ by less count as equal (25i, INFERRED)
    const auto off = [](double a, double b) { return std::fabs(std::remainder(a - b, 360.0)); };
    if (!reached || off(reached->first, programmed.first) > same_angle || off(reached->second, programmed.second) > same_angle) {
      const double tilt = space->data().machine.group == MachineGroup::head_head ? programmed.second : programmed.first;
      return fail(alarm(AlarmId::lead_angle, m.block->where, tilt));
    }
  }
  auto detail = motion.detail ? std::make_shared<MotionDetail>(*motion.detail) : std::make_shared<MotionDetail>();
  detail->tip_path = std::move(tip_path);
  motion.detail = std::move(detail);
  if (controls_contact(five.tip_control)) {
    const Axes tip = motion.detail->tip_path->at(1, motion.to);
    m.position.machine = m.frames.machine_of(tip);
    motion.machine = m.position.machine;
  }
  return {};
}

}  // namespace kadr::fanuc

namespace kadr::functions {

using namespace fanuc;

/// Executes G43.1, G43.4, G43.5, G43.8, G43.9. call.row->arg is the code in tenths. INFERRED: without H, the offset number in force is
/// used. In a block without words that move an axis, the new tool length causes no motion; only the reported position changes.
Status tool_lead(Emitter& m, const Call& call) {
  FiveAxisState& five = fanuc_of(m).state.five_axis;
  const TipControl tip_control = tip_control_of(call.row->arg);
  if (m.modal.smoothing == 3) return fail(alarm(AlarmId::smoothing_length, call.where, call.row->code));
  if (fanuc_of(m).settings.five_axis.group == MachineGroup::none) return fail(alarm(AlarmId::no_five_axes, call.where, call.row->code));
  if (!straight_mode(m)) return fail(alarm(AlarmId::lead_mode, call.where, call.row->code));
  if (controls_tip(tip_control)) KADR_TRY(nothing_else(m, call));
  const auto p = m.has('P') && tip_control != TipControl::axis ? m.whole('P', 0, 1) : Result<std::uint32_t>(0);
  if (!p) return fail(p.error());
  if (m.has('H')) {
    const auto number = offset_number(m, 'H');
    if (!number) return fail(number.error());
    m.modal.length_number = *number;
    macro_b_of(m).state.words.h = *number;
  }
  m.modal.turning_lengths = false;
  m.modal.length_sign = 1;
  if (five.tip_control != tip_control) five.positioned = 0;
  five.tip_control = tip_control;
  five.posture = *p == 1;
  const std::uint32_t number = m.modal.length_number;
  const double length = number < m.tables.offsets.size() ? m.tables.offsets[number].whole_length() : 0;
  if (number != 0) m.use.note(UseKind::length, number, m.origin, length == 0);
  register_tip_length(m, number == 0 ? 0 : length);
  note_tip_radius(m);
  const Axes before = m.position.programmed;
  m.change_frames();
  five.begins = true;
  const bool moves = m.has_axis_words() || fanuc_of(m).by_direction != 0;
  const FiveAxisTransform& space = *space_of(m);
  AxisMask named = 0;
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if (m.letters.axis_letter[a] != 0 && m.has(m.letters.axis_letter[a])) named |= AxisMask{1} << a;
  if (moves && !space.changes_work(named)) take_up(m, before);
  return {};
}

}  // namespace kadr::functions
