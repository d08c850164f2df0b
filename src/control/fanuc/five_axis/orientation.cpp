// G53.1, G53.6: orient the rotary axes to the tilted plane (spec/nct/25g); G54.2: dynamic zero offset of rotary tables (25d).
// Numbers in brackets such as 25.15 are sections of the NCT programming manual. Used by control/functions.

#include <cmath>
#include <utility>

#include "control/fanuc/fanuc.h"
#include "control/fanuc/five_axis/five_axis_functions.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"
#include "kinematics/five_axis_tip_path.h"
#include "kinematics/five_axis_transform.h"

namespace kadr::fanuc {
namespace {

constexpr int orient_alone = 531;  // code in tenths: G53.1

/// Returns the positions (machine coordinates, degrees) of the two rotary axes that align the tool with the Z' axis of the tilted plane
/// (NCT manual 25.11; spec/nct/25g 3).
Result<RotaryPair> pair_for_plane(const BlockContext& m, const Call& call) {
  const FiveAxisTransform& space = *space_of(m);
  const FiveAxisTransformData& d = space.data();
  Vec3 target = d.frame.column(2);
  if (fanuc_of(m).settings.tilts_tool) target = d.basic * target;
  const auto pair = d.machine.chosen(target, space.rotary(m.position.machine), d.measured);
  if (!pair) return fail(alarm(AlarmId::direction_unreachable, call.where, target.x, target.y, target.z));
  return *pair;
}

/// Returns the real position of the tool tip on the part, in coordinates of the programming frame. The tool length in force is included
/// (spec/nct/25g 1.5, INFERRED).
Vec3 tip_in_frame(const BlockContext& m) {
  const FiveAxisTransform& space = *space_of(m);
  return space.in_frame(space.pose(m.position.machine).tip);
}

void set_main(const BlockContext& m, Axes& work, Vec3 to) {
  const double values[] = {to.x, to.y, to.z};
  for (int role = 1; role <= 3; ++role)
    if (const int axis = main_axis(m, role); axis >= 0) work[static_cast<std::size_t>(axis)] = values[role - 1];
}

void set_rotary(const BlockContext& m, Axes& work, RotaryPair machine) {
  const FiveAxis& five = fanuc_of(m).settings.five_axis;
  const auto set = [&](int axis, double to) {
    work[static_cast<std::size_t>(axis)] = to - m.frames.origin[static_cast<std::size_t>(axis)];
  };
  set(five.first.axis, machine.first);
  set(five.second.axis, machine.second);
}

AxisMask all_five(const BlockContext& m) {
  AxisMask axes = space_of(m)->rotary_axes();
  for (int role = 1; role <= 3; ++role)
    if (const int axis = main_axis(m, role); axis >= 0) axes |= AxisMask{1} << static_cast<unsigned>(axis);
  return axes;
}

/// Returns the kind of motion for the code in force: rapid for G0, a motion at feed for all other codes (NCT manual 25.15; for G53.1
/// INFERRED).
Result<MotionKind> kind_in_force(Emitter& m, const Call& call) {
  if (m.modal.motion == MotionMode::rapid || m.modal.motion == MotionMode::none) return MotionKind::rapid;
  KADR_TRY(m.feed_known(call.where));
  return MotionKind::feed;
}

/// Adds a straight motion of all five axes to the point `work`, in work coordinates of the frames in force.
Motion& add_five(Emitter& m, MotionKind kind, const Axes& work) {
  const AxisMask named = all_five(m);
  const auto rolls = fanuc_of(m).settings.axes;
  fanuc_of(m).rolled = 0;
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    if ((named >> a & 1u) == 0 || !rolls[a].rolls || (m.def.rotary >> a & 1u) == 0) continue;
    fanuc_of(m).travel[a] = work[a] - m.position.work[a];
    fanuc_of(m).rolled |= AxisMask{1} << a;
  }
  m.move_to(m.transform.to_programmed(work), work, named);
  Motion& motion = m.add_motion(kind, named);
  if (kind != MotionKind::rapid) m.set_feed(motion);
  m.position.programmed = m.transform.to_programmed(m.position.work);
  return motion;
}

Status turn_to_plane(Emitter& m, const Call& call) {
  const auto kind = kind_in_force(m, call);
  if (!kind) return fail(kind.error());
  const auto pair = pair_for_plane(m, call);
  if (!pair) return fail(pair.error());
  const Vec3 tip = tip_in_frame(m);
  fanuc_of(m).state.five_axis.oriented = *pair;
  m.change_frames();
  Axes work = m.position.work;
  set_rotary(m, work, *pair);
  if (!fanuc_of(m).settings.keeps_linear) set_main(m, work, tip);
  add_five(m, *kind, work);
  return {};
}

/// The words X Y Z (end point) and R of a block with G53.6 (NCT manual 25.15; spec/nct/25g 5).
struct Leading {
  std::optional<Vec3> end;  // end point X Y Z in the programming frame
  double pivot = 0;
};

Result<Leading> leading_words(const BlockContext& m, const Call& call, Vec3 tip) {
  Leading words;
  if (m.has('R')) words.pivot = m.length_value('R');
  if (!m.has_axis_words()) return words;
  if (m.has('R')) return fail(alarm(AlarmId::words_exclude, m.where('R'), "R", "X Y Z"));
  (void)call;
  Axes to = m.position.programmed;
  set_main(m, to, tip);  // an axis without a word keeps its present coordinate
  const Axes here = m.transform.to_programmed(to);
  to = here;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address == 0 || (m.letters.axes & letter_bit(w.address)) == 0) continue;
    const std::size_t axis = m.def.address(w.address).axis;
    const int role = fanuc_of(m).settings.axes[axis].role;
    if (role < 1 || role > 3) return fail(alarm(AlarmId::illegal_address, w.where, w.written));
    const double v = coordinate(m, w, axis);
    to[axis] = is_increment(m, w) ? here[axis] + v : v;
    if (!(std::fabs(to[axis]) <= farthest)) return fail(alarm(AlarmId::position_out_of_range, w.where, w.address, to[axis]));
  }
  const Axes work = m.transform.to_work(to);
  Vec3 end;
  double* const parts[] = {&end.x, &end.y, &end.z};
  for (int role = 1; role <= 3; ++role)
    if (const int axis = main_axis(m, role); axis >= 0) *parts[role - 1] = work[static_cast<std::size_t>(axis)];
  words.end = end;
  return words;
}

/// Puts the tool length that H selects into force. The mode of length compensation in force decides whether this length acts along one axis
/// or along the tool's direction (NCT manual 25.15).
Status take_orientation_length(Emitter& m, const Call& call) {
  FiveAxisState& five = fanuc_of(m).state.five_axis;
  if (m.has('H')) {
    const auto number = offset_number(m, 'H');
    if (!number) return fail(number.error());
    m.modal.length_number = *number;
    macro_b_of(m).state.words.h = *number;
  }
  if (m.modal.length_number == 0) return fail(alarm(AlarmId::length_missing, call.where, call.row->code));
  if (five.tip_control == TipControl::axis && !m.has('H')) return {};
  const std::uint32_t number = m.modal.length_number;
  const double length = number < m.tables.offsets.size() ? m.tables.offsets[number].whole_length() : 0;
  m.use.note(UseKind::length, number, m.origin, length == 0);
  if (five.tip_control == TipControl::axis) {
    register_tip_length(m, length);
  } else {
    m.modal.lengths = {};
    const Vec3 along = length * fanuc_of(m).settings.five_axis.tool;
    Axes lengths{};
    set_main(m, lengths, along);
    m.modal.lengths = lengths;
    m.modal.length_sign = 1;
  }
  m.change_frames();
  return {};
}

/// Executes G53.6: rotates the axes with tool centre point control. Afterwards the frame of the tilted plane is valid for the positions
/// that the rotary axes have reached.
Status orient_with_tip_control(Emitter& m, const Call& call) {
  macro_b_of(m).stops_reading = true;
  const auto kind = kind_in_force(m, call);
  if (!kind) return fail(kind.error());
  KADR_TRY(take_orientation_length(m, call));
  const auto pair = pair_for_plane(m, call);
  if (!pair) return fail(pair.error());
  const Vec3 tip = tip_in_frame(m);
  const auto words = leading_words(m, call, tip);
  if (!words) return fail(words.error());
  FiveAxisState& five = fanuc_of(m).state.five_axis;
  const double along =
      five.tip_control == TipControl::axis ? five.tip_length : dot(space_of(m)->data().length, space_of(m)->data().machine.tool);
  const TipControl tip_control = std::exchange(five.tip_control, TipControl::tip);
  const double length = std::exchange(five.tip_length, along);
  five.oriented.reset();
  m.change_frames();  // tool centre point control is on for this motion only, so the frames are computed again
  Axes work = m.position.work;
  set_rotary(m, work, *pair);
  FiveAxisTipPath::Data tip_path;
  tip_path.space = std::static_pointer_cast<const FiveAxisTransform>(m.frames.space);
  tip_path.start = m.position.work;
  if (words->end) set_main(m, work, *words->end);
  if (words->pivot != 0) {
    tip_path.pivot = words->pivot;
    tip_path.end = work;
    const FiveAxisTransform& space = *tip_path.space;
    const Vec3 from = space.in_system(tip);
    const Vec3 lean = space.direction_of(*pair) - space.direction_of(space.rotary(m.position.machine));
    set_main(m, work, space.in_frame(from + words->pivot * lean));
  }
  Motion& motion = add_five(m, *kind, work);
  if (tip_path.pivot) detail_of(m, motion).tip_path = std::make_shared<const FiveAxisTipPath>(tip_path);
  five.tip_control = tip_control;  // restores the mode of tool centre point control that was in force before the block
  five.tip_length = length;
  five.oriented = *pair;
  m.change_frames();
  return {};
}

}  // namespace
}  // namespace kadr::fanuc

namespace kadr::functions {

using namespace fanuc;

/// Executes G53.1, G53.6 (NCT manual 25.11, 25.15). call.row->arg is the code in tenths.
Status tool_orientation(Emitter& m, const Call& call) {
  const FiveAxisState& five = fanuc_of(m).state.five_axis;
  if (five.frame != SpaceFrame::plane) return fail(alarm(AlarmId::frame_missing, call.where, call.row->code));
  if (fanuc_of(m).settings.five_axis.group == MachineGroup::none) return fail(alarm(AlarmId::no_five_axes, call.where, call.row->code));
  if (m.modal.radius_side != 0) return fail(alarm(AlarmId::compensation_active, call.where, call.row->code));
  return call.row->arg == orient_alone ? turn_to_plane(m, call) : orient_with_tip_control(m, call);
}

/// G54.2 P (NCT manual 25.4): selects a dynamic offset. If parameter bit FOS is 0, the linear axes move with the origin, so that their
/// coordinates stay the same. The motion is at feed if G1 is in force, otherwise at rapid.
Status dynamic_zero(Emitter& m, const Call& call) {
  if (!fanuc_of(m).settings.five_axis.has_table()) return fail(alarm(AlarmId::no_five_axes, call.where, call.row->code));
  if (m.modal.surface != PathSurface::plane) return fail(alarm(AlarmId::surface_state, call.where, call.row->code));
  if (controls_tip(fanuc_of(m).state.five_axis.tip_control)) return fail(alarm(AlarmId::lead_state, call.where, call.row->code, "G43.4"));
  if (!m.has('P')) return fail(alarm(AlarmId::word_missing, call.where, 'P', call.row->code));
  const auto number = m.whole('P', 1, dynamic_systems);
  if (!number) return fail(number.error());
  const auto row = static_cast<std::uint16_t>(all_systems - 1 + *number);
  fanuc_of(m).state.five_axis.positioned = 0;
  m.modal.work_zero = row;
  note_work_offset(m, row);
  const Axes before = m.position.programmed;
  m.change_frames();
  if (fanuc_of(m).settings.keeps_linear) return {};
  take_up(m, before);
  if (m.has_axis_words()) return {};
  const bool straight = m.modal.motion == MotionMode::rapid || m.modal.motion == MotionMode::linear;
  const auto kind = straight ? kind_in_force(m, call) : Result<MotionKind>(MotionKind::rapid);
  if (!kind) return fail(kind.error());
  const Axes programmed = m.position.programmed;
  return m.straight(*kind, programmed, std::exchange(fanuc_of(m).taken_up, AxisMask{0}));
}

}  // namespace kadr::functions
