// PLANE and cycle 19: the tilted working plane (spec/heidenhain 13). Used by control/heidenhain.

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/tolerance.h"
#include "control/heidenhain/heidenhain.h"
#include "kinematics/five_axis_transform.h"

namespace kadr::heidenhain {
namespace {

Vec3 in_space(const Axes& axes) { return {axes[0], axes[1], axes[2]}; }

Mat3 about_fixed_axes(double a, double b, double c) {
  return Mat3::about({0, 0, 1}, c) * Mat3::about({0, 1, 0}, b) * Mat3::about({1, 0, 0}, a);
}

double size(Vec3 v) { return std::sqrt(dot(v, v)); }

}  // namespace

void Heidenhain::place_in_space(Emitter& m) {
  FiveAxisTransformData data;
  data.machine = five_axis;
  data.zero = in_space(m.frames.origin);
  data.follows_table = five_axis.has_table();
  data.follows_head = five_axis.has_head();
  data.controls_tip = memory.holds_tip;
  if (memory.tilted) {
    data.has_frame = true;
    data.frame = memory.tilt;
    data.frame_origin = in_space(memory.tilt_origin);
    if (!memory.holds_tip) data.fixed = memory.tilt_at.value_or(RotaryPair());
  }
  data.length = in_space(m.frames.length);
  auto made = std::make_shared<const FiveAxisTransform>(data);
  const auto now = made->turn();
  m.frames.space = std::move(made);
  if (now) m.frames.turn = std::make_shared<const FrameTurn>(FrameTurn{now->rows, data.main, {}});
}

/// Tilts the working plane about the active datum. Shift, mirror image and rotation then act in the tilted system.
Status Heidenhain::tilt(Emitter& m, const Mat3& to) {
  if (!memory.tilted) {
    memory.tilt_origin = memory.shift;
    memory.shift = {};
  }
  memory.tilted = true;
  memory.tilt = to;
  m.change_frames();
  return set_frame(m);
}

void Heidenhain::untilt(Emitter& m) {
  if (!memory.tilted) return;
  memory.tilted = false;
  memory.shift = memory.tilt_origin;
  memory.tilt_origin = {};
  m.change_frames();
}

// NOLINTNEXTLINE(readability-function-size): the forms in the order of the manual
Status Heidenhain::plane(Interpreter& m, const KlartextBlock& block) {
  const auto number = [&](std::string_view name) -> double {
    const KlartextWord* const word = block.find(name);
    if (word == nullptr) return 0;
    const auto read = value(m, block, *word);
    return read ? *read : undefined;
  };
  for (const KlartextWord& word : block.words) {
    const auto read = value(m, block, word);
    if (!read) return fail(read.error());
  }
  const bool moves = block.find("MOVE") != nullptr || block.find("TURN") != nullptr;
  if (block.name == "RESET") {
    untilt(m);
    KADR_TRY(set_frame(m));
    for (std::size_t i = 0; i < 3; ++i) memory.q[120 + i] = 0;
    return moves ? turn_axes(m, block) : Status();
  }
  Mat3 to;
  if (block.name == "SPATIAL") {
    to = about_fixed_axes(number("SPA"), number("SPB"), number("SPC"));
  } else if (block.name == "EULER") {
    to = Mat3::about({0, 0, 1}, number("EULPR")) * Mat3::about({1, 0, 0}, number("EULNU")) * Mat3::about({0, 0, 1}, number("EULROT"));
  } else if (block.name == "RELATIV" || block.name == "RELATIVE") {
    to = memory.tilted ? memory.tilt : Mat3();
    if (block.find("SPA") != nullptr) to = to * Mat3::about({1, 0, 0}, number("SPA"));
    else if (block.find("SPB") != nullptr) to = to * Mat3::about({0, 1, 0}, number("SPB"));
    else to = to * Mat3::about({0, 0, 1}, number("SPC"));
  } else if (block.name == "AXIAL") {
    KADR_TRY(retract_first(m, block));
    KADR_TRY(take_axis_positions(m, block, to));
    KADR_TRY(tilt(m, to));
    return moves ? turn_axes(m, block) : Status();
  } else if (block.name == "VECTOR" || block.name == "POINTS" || block.name == "PROJECTED") {
    Vec3 x, z;
    if (block.name == "PROJECTED") {
      // The lines in which the plane meets ZX and YZ rise with positive angles; X lies above the line in ZX, turned by ROT (INFERRED).
      const SinCos one = sincos_deg(number("PROPR")), two = sincos_deg(number("PROMIN"));
      x = {one.cos, 0, one.sin};
      z = cross(x, Vec3{0, two.cos, two.sin});
    } else if (block.name == "VECTOR") {
      x = {number("BX"), number("BY"), number("BZ")};
      z = {number("NX"), number("NY"), number("NZ")};
    } else {
      const Vec3 first{number("P1X"), number("P1Y"), number("P1Z")};
      x = Vec3{number("P2X"), number("P2Y"), number("P2Z")} - first;
      z = cross(x, Vec3{number("P3X"), number("P3Y"), number("P3Z")} - first);
    }
    if (!(size(z) > tol::same_point)) return fail(alarm(AlarmId::plane_degenerate, block.where));
    z = 1 / size(z) * z;
    x = x - dot(x, z) * z;
    if (!(size(x) > tol::same_point)) return fail(alarm(AlarmId::plane_degenerate, block.where));
    x = 1 / size(x) * x;
    to = Mat3::of_columns(x, cross(z, x), z);
    if (block.name == "PROJECTED") to = to * Mat3::about({0, 0, 1}, number("ROT"));
  } else {
    return fail(alarm(AlarmId::not_available, block.where, std::string_view("PLANE " + block.name)));
  }
  KADR_TRY(retract_first(m, block));
  KADR_TRY(set_axis_angles(m, to, block));
  KADR_TRY(tilt(m, to));
  return moves ? turn_axes(m, block) : Status();
}

/// TURN MB 50: the tool goes back along its axis before the rotary axes turn (spec/heidenhain 13.2).
Status Heidenhain::retract_first(Interpreter& m, const KlartextBlock& block) {
  const KlartextWord* const word = block.find("MB");
  if (block.find("MBMAX") != nullptr) {
    const std::size_t axis = m.modal.axes.normal;
    if (!(most[axis] < 1e300)) return fail(alarm(AlarmId::not_available, block.where, "MB MAX"));
    Axes to = m.position.machine;
    to[axis] = most[axis];
    return m.to_machine(MotionKind::rapid, to, AxisMask{1} << axis, 0);
  }
  if (word == nullptr) return {};
  const auto by = value(m, block, *word);
  if (!by) return fail(by.error());
  if (five_axis.group == MachineGroup::none) return fail(alarm(AlarmId::no_five_axes, block.where, "PLANE"));
  const Vec3 way = *by * m.unit_scale() * (five_axis.head_turn(rotary_now(m)) * five_axis.tool);
  Axes to = m.position.machine;
  to[0] += way.x, to[1] += way.y, to[2] += way.z;
  return m.to_machine(MotionKind::rapid, to, 7U, 0);
}

RotaryPair Heidenhain::rotary_now(const BlockContext& m) const {
  const auto at = [&](const RotaryJoint& joint) {
    return joint.axis >= 0 ? m.position.machine[static_cast<std::size_t>(joint.axis)] : 0.0;
  };
  return {at(five_axis.first), at(five_axis.second)};
}

/// PLANE AXIAL: the plane that the positions of the rotary axes give; one that is not named stays where it is.
///   alarms  no_five_axes; not_available: a word of an axis that the machine does not have
Status Heidenhain::take_axis_positions(BlockContext& m, const KlartextBlock& block, Mat3& to) {
  if (five_axis.group == MachineGroup::none) return fail(alarm(AlarmId::no_five_axes, block.where, "PLANE AXIAL"));
  RotaryPair pair = rotary_now(m);
  for (const KlartextWord& word : block.words)
    for (const char letter : {'A', 'B', 'C'}) {
      if (word.name != word_name(std::string_view(&letter, 1))) continue;
      const auto read = value(m, block, word);
      if (!read) return fail(read.error());
      bool known = false;
      for (const bool first : {true, false}) {
        const RotaryJoint& joint = first ? five_axis.first : five_axis.second;
        if (joint.axis < 0 || m.def.axes[static_cast<std::size_t>(joint.axis)][0] != letter) continue;
        (first ? pair.first : pair.second) = *read;
        known = true;
      }
      if (!known) return fail(alarm(AlarmId::not_available, word.where, letter));
    }
  to = transposed(five_axis.table_turn(pair, {})) * five_axis.head_turn(pair);
  note_axis_angles(m, pair);
  return {};
}

/// Sets Q120 to Q122.
void Heidenhain::note_axis_angles(const BlockContext& m, RotaryPair pair) {
  for (std::size_t i = 0; i < 3; ++i) memory.q[120 + i] = 0;
  memory.tilt_at = pair;
  for (const auto& [joint, angle] : {std::pair(&five_axis.first, pair.first), std::pair(&five_axis.second, pair.second)}) {
    if (joint->axis < 0) continue;
    const char letter = m.def.axes[static_cast<std::size_t>(joint->axis)][0];
    if (letter >= 'A' && letter <= 'C') memory.q[120 + static_cast<std::size_t>(letter - 'A')] = angle;
  }
}

/// Computes Q120 to Q122, the positions of the rotary axes that the plane needs (spec/heidenhain 13.2).
///   alarms  direction_unreachable
Status Heidenhain::set_axis_angles(BlockContext& m, const Mat3& to, const KlartextBlock& block) {
  // Without the machine's rotary axes the angles are not known; a program that uses them stops.
  for (std::size_t i = 0; i < 3; ++i) memory.q[120 + i] = five_axis.group == MachineGroup::none ? undefined : 0;
  memory.tilt_at.reset();
  if (five_axis.group == MachineGroup::none) return {};
  const Vec3 normal = to.column(2);
  const RotaryPair present = rotary_now(m);
  const RotarySolutions all = five_axis.solutions(normal);
  if (all.count == 0) return fail(alarm(AlarmId::direction_unreachable, block.where, normal.x, normal.y, normal.z));
  std::optional<RotaryPair> chosen = five_axis.chosen(normal, present);
  const KlartextWord* sign = block.find("SEQ");
  if (sign == nullptr) sign = block.find("SYM");
  if (sign != nullptr)
    for (int i = 0; i < all.count; ++i) {
      const RotaryPair& pair = all.pairs[static_cast<std::size_t>(i)];
      // The master axis: the first rotary axis from the tool, or the last one from the table, is the tilting one.
      if ((pair.first < 0) == (sign->number < 0)) chosen = pair;
    }
  if (!chosen) return fail(alarm(AlarmId::direction_unreachable, block.where, normal.x, normal.y, normal.z));
  note_axis_angles(m, *chosen);
  return {};
}

/// TURN: the rotary axes go to the positions of the plane.
Status Heidenhain::turn_axes(Interpreter& m, const KlartextBlock& block) {
  if (five_axis.group == MachineGroup::none) return fail(alarm(AlarmId::no_five_axes, block.where, "PLANE"));
  Axes to = m.position.machine;
  AxisMask named = 0;
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    const char letter = m.def.axes[a][0];
    if (static_cast<int>(a) != five_axis.first.axis && static_cast<int>(a) != five_axis.second.axis) continue;
    to[a] = memory.q[120 + static_cast<std::size_t>(letter - 'A')];
    named |= AxisMask{1} << a;
  }
  if (named == 0) return {};
  if (block.find("MOVE") != nullptr) {
    // The tool stays where it is relative to a point of the part, DIST below the tip (INFERRED; the sense of DIST in spec/heidenhain 13.2).
    const KlartextWord* const word = block.find("DIST");
    const auto distance = word == nullptr ? Result<double>(0.0) : value(m, block, *word);
    if (!distance) return fail(distance.error());
    const double by = *distance * m.unit_scale();
    const RotaryPair before = rotary_now(m);
    const RotaryPair after{five_axis.first.axis < 0 ? 0 : to[static_cast<std::size_t>(five_axis.first.axis)],
                           five_axis.second.axis < 0 ? 0 : to[static_cast<std::size_t>(five_axis.second.axis)]};
    const Vec3 length = in_space(m.frames.length);
    const Vec3 tip = five_axis.point_in_part(before, in_space(m.position.machine) - five_axis.length_vector(before, length));
    const Vec3 there = tip - by * five_axis.direction(before) + by * five_axis.direction(after);
    const Vec3 end = five_axis.point_on_machine(after, there) + five_axis.length_vector(after, length);
    to[0] = end.x, to[1] = end.y, to[2] = end.z;
    named |= 7U;
  }
  const KlartextWord* const feed = block.find("F");
  const auto rate = feed == nullptr ? Result<double>(0.0) : value(m, block, *feed);
  if (!rate) return fail(rate.error());
  return m.to_machine(feed == nullptr ? MotionKind::rapid : MotionKind::feed, to, named, *rate);
}

}  // namespace kadr::heidenhain
