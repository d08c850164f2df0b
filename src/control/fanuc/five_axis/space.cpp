// Computes from the codes in force the transformation between work and machine coordinates (spec/nct/25a 6.3). Used by
// control/fanuc/frames/frames and the functions of this folder.

#include "control/emitter.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/five_axis/five_axis_functions.h"
#include "control/fanuc/words/coordinates.h"
#include "kinematics/five_axis_transform.h"

namespace kadr::fanuc {
namespace {

/// Returns the basic rotation of the work system: M_Z(gamma)·M_Y(beta)·M_X(alpha) (10.2.3).
Mat3 basic_rotation(const BlockContext& m) {
  const Vec3 angles = m.tables.rotations[m.modal.work_zero];
  return Mat3::about({0, 0, 1}, angles.x) * Mat3::about({0, 1, 0}, angles.y) * Mat3::about({1, 0, 0}, angles.z);
}

Vec3 main_of(const BlockContext& m, const Axes& axes) {
  const auto of = [&](int role) {
    const int a = main_axis(m, role);
    return a < 0 ? 0.0 : axes[static_cast<std::size_t>(a)];
  };
  return {of(1), of(2), of(3)};
}

Axes shifts(const BlockContext& m) {
  Axes sum{};
  for (std::size_t a = 0; a < m.axis_count; ++a) sum[a] = m.modal.new_system[a] + m.modal.local[a];
  return sum;
}

/// Sets the origin of the work system, and the rotary table positions at which the origin was measured (25a 7, 25d).
void set_zero(const Emitter& m, FiveAxisTransformData& d) {
  const FiveAxis& machine = d.machine;
  const Axes& zero = m.tables.zeros[m.modal.work_zero];
  const auto of = [&](const RotaryJoint& joint, bool on_table, const Axes& from) {
    return on_table && joint.axis >= 0 ? from[static_cast<std::size_t>(joint.axis)] : 0.0;
  };
  if (d.moves_origin) {
    // With a dynamic offset, the origin of the work system is relative to the pivot of the second rotary table. INFERRED: the common work
    // offset is not added.
    d.measured = {of(machine.first, machine.first_on_table(), zero), of(machine.second, machine.second_on_table(), zero)};
    const Mat3 first = machine.first_on_table() ? machine.first_turn(d.measured.first) : Mat3();
    d.zero = main_of(m, zero) + machine.table + first * machine.second_table;
  } else {
    Axes sum = zero;
    for (std::size_t a = 0; a < m.axis_count; ++a) sum[a] += m.tables.common[a];
    d.zero = main_of(m, sum);
    d.measured = {of(machine.first, machine.first_on_table(), sum), of(machine.second, machine.second_on_table(), sum)};
  }
}

FiveAxisTransformData data_of(const Emitter& m) {
  const Fanuc& fanuc = fanuc_of(m);
  const FiveAxisState& five = fanuc.state.five_axis;
  const bool dynamic = m.modal.work_zero >= all_systems;
  FiveAxisTransformData d;
  d.machine = fanuc.settings.five_axis;
  if (d.machine.group == MachineGroup::none) d.machine = {};
  const auto limits = [&](RotaryJoint& joint) {
    if (joint.axis < 0) return;
    std::tie(joint.least, joint.most) = fanuc.axis_limits[static_cast<std::size_t>(joint.axis)];
  };
  limits(d.machine.first);
  limits(d.machine.second);
  for (int role = 1; role <= 3; ++role) d.main[static_cast<std::size_t>(role - 1)] = static_cast<std::int8_t>(main_axis(m, role));
  d.basic = basic_rotation(m);
  d.has_frame = five.frame != SpaceFrame::none;
  d.controls_tip = controls_tip(five.tip_control);
  d.follows_table = (d.controls_tip || five.oriented) && d.machine.has_table();
  d.follows_head = (five.tip_control != TipControl::none || five.oriented) && d.machine.has_head();
  d.moves_origin = dynamic && !d.follows_table;
  set_zero(m, d);
  d.fixed = five.oriented;
  d.keeps_linear = fanuc.settings.keeps_linear && !d.controls_tip;
  const Axes all = shifts(m);
  if (d.has_frame) {
    d.frame = five.turn;
    d.frame_origin = five.origin;
    Axes inner = all;
    for (std::size_t a = 0; a < m.axis_count; ++a) inner[a] -= five.outer_shift[a];
    d.shift = main_of(m, inner);
    d.zero = d.zero + d.basic * main_of(m, five.outer_shift);
  } else {
    d.zero = d.zero + d.basic * main_of(m, all);
  }
  d.length = five.tip_control != TipControl::none ? five.tip_length * d.machine.tool : main_of(m, m.modal.lengths);
  const AxisMask rotary = FiveAxisTransform(d).rotary_axes();
  const bool in_five_axes = d.follows_table || d.follows_head || d.moves_origin || d.controls_tip;
  d.corrects = fanuc.settings.tilts_tool && in_five_axes && !(d.basic == Mat3()) && (five.positioned & rotary) == rotary && !five.oriented;
  return d;
}

}  // namespace

const FiveAxisTransform* space_of(const BlockContext& m) { return static_cast<const FiveAxisTransform*>(m.frames.space.get()); }

std::shared_ptr<const WorkTransform> five_axis_transform(const Emitter& m, const std::shared_ptr<const WorkTransform>& before) {
  const Fanuc& fanuc = fanuc_of(m);
  if (fanuc.settings.five_axis.group == MachineGroup::none && fanuc.state.five_axis.frame == SpaceFrame::none) return nullptr;
  const FiveAxisTransformData data = data_of(m);
  if (before && static_cast<const FiveAxisTransform&>(*before).data() == data) return before;
  return std::make_shared<const FiveAxisTransform>(data);
}

/// Computes the frames in force. Five-axis functions apply the work offset of a rotary axis of the table, but not that of a rotary axis of
/// the head (25a 7).
void refresh_space(Emitter& m) {
  Placement& f = m.frames;
  f.space = five_axis_transform(m, f.space);
  if (!f.space || f.space->is_plain()) return;
  const FiveAxisTransformData& d = space_of(m)->data();
  const auto head = [&](const RotaryJoint& joint, bool on_table) {
    if (joint.axis >= 0 && !on_table && d.follows_head) f.origin[static_cast<std::size_t>(joint.axis)] = 0;
  };
  head(d.machine.first, d.machine.first_on_table());
  head(d.machine.second, d.machine.second_on_table());
  const auto turn = space_of(m)->turn();
  const AxisDrives& drives = fanuc_of(m).driven;
  if (!turn || (*turn == Mat3() && drives.is_own)) {
    f.turn = nullptr;
  } else if (!f.turn || f.turn->rows != turn->rows || f.turn->main != d.main || f.turn->drives != drives) {
    f.turn = std::make_shared<const FrameTurn>(FrameTurn{turn->rows, d.main, drives});
  }
  // Placement keeps the origin (the work offset) and the tool length (for rotary axes at 0), because reports show both. The shift is set to
  // 0, because the transformation `space` contains it.
  for (const std::int8_t axis : d.main)
    if (axis >= 0) f.shift[static_cast<std::size_t>(axis)] = 0;
}

void take_up(BlockContext& m, const Axes& programmed_before) {
  const FiveAxisTransform* const space = space_of(m);
  if (space == nullptr) return;
  fanuc_of(m).taken_up = 0;
  for (const std::int8_t axis : space->data().main)
    if (axis >= 0) {
      const auto a = static_cast<std::size_t>(axis);
      m.position.programmed[a] = programmed_before[a];
      fanuc_of(m).taken_up |= AxisMask{1} << a;
    }
}

void note_positioned(Emitter& m, AxisMask named) {
  FiveAxisState& five = fanuc_of(m).state.five_axis;
  const FiveAxisTransform* const space = space_of(m);
  if (space == nullptr || !fanuc_of(m).settings.tilts_tool) return;
  const AxisMask now = five.positioned | (named & space->rotary_axes());
  if (now == five.positioned) return;
  five.positioned = now;
  if (!space->data().corrects) {
    const Axes programmed = m.position.programmed;
    m.change_frames();
    m.position.programmed = programmed;
  }
}

}  // namespace kadr::fanuc
