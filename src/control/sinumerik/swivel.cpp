// CYCLE800: the swivelled working plane (spec/sinumerik 14.6); TRAORI (spec/sinumerik 15). Used by control/sinumerik.

#include <algorithm>
#include <cmath>

#include "control/sinumerik/sinumerik.h"

namespace kadr::sinumerik {
namespace {

/// The parameters by their place in the call.
enum Place : std::size_t { stepping = 2, mode = 3, shift = 4, angles = 7, shift_after = 10, direction = 13 };

/// Returns true for a call that only goes back to the initial state: without arguments, or with nothing but a name.
bool swivels_back(const std::vector<Value>& arguments) {
  return std::all_of(arguments.begin(), arguments.end(), [](const Value& each) {
    return each.omitted || (each.type == Type::text && (each.text.empty() || each.text == "0"));
  });
}

Axes shifted(double x, double y, double z) {
  Axes to{};
  to[0] = x, to[1] = y, to[2] = z;
  return to;
}

}  // namespace

Status Sinumerik::swivel(Interpreter& m, const std::vector<Value>& arguments, Span where) {
  if (m.modal.radius_side != 0) return fail(alarm(AlarmId::compensation_active, where, "CYCLE800"));
  const bool back = swivels_back(arguments);
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (i != 1 && !arguments[i].omitted && !arguments[i].is_number() && !back) return fail(alarm(AlarmId::operand_type, where, "CYCLE800"));
  const auto number = [&](std::size_t i) { return i < arguments.size() && !arguments[i].omitted ? arguments[i].number : 0.0; };
  const auto at = [&](std::size_t first) {
    const double unit = m.unit_scale();
    return shifted(number(first) * unit, number(first + 1) * unit, number(first + 2) * unit);
  };
  Frame frame;
  if (!back) {
    const int bits = static_cast<int>(std::lround(number(mode)));
    if (bits < 0 || bits > 0xFF || bits >> 6 != 0) return fail(alarm(AlarmId::not_available, where, "CYCLE800 _MODE"));
    Frame turn;
    for (int i = 0; i < 3; ++i) {  // the axes in their order; each angle turns about the axis that the ones before have turned
      const int axis = bits >> (2 * i) & 3;
      const double angle = number(angles + static_cast<std::size_t>(i));
      if (axis == 0 && angle != 0) return fail(alarm(AlarmId::value_out_of_range, where, "_MODE", number(mode)));
      if (axis != 0) turn.linear = product(turn.linear, rotation_about(static_cast<std::size_t>(axis - 1), angle));
    }
    Frame before, after;
    before.shift = at(shift);
    after.shift = at(shift_after);
    frame = chained(before, chained(turn, after));
    if (std::fmod(std::fabs(number(stepping)), 10) == 1) frame = chained(memory.swivel, frame);
  }
  const bool turns = rotary.group != MachineGroup::none;
  std::optional<RotaryPair> to;
  if (turns && !back) {
    const Vec3 normal{frame.linear[0][2], frame.linear[1][2], frame.linear[2][2]};
    const auto at_joint = [&](const RotaryJoint& joint) { return m.position.machine[static_cast<std::size_t>(joint.axis)]; };
    to = rotary.chosen(normal, {at_joint(rotary.first), at_joint(rotary.second)});
    const RotarySolutions all = rotary.solutions(normal);
    if (const double way = number(direction); way != 0)  // INFERRED: the sign of the first rotary axis
      for (int i = 0; i < all.count; ++i)
        if (const RotaryPair& pair = all.pairs[static_cast<std::size_t>(i)]; (pair.first < 0) == (way < 0)) to = pair;
    if (!to) return fail(alarm(AlarmId::direction_unreachable, where, normal.x, normal.y, normal.z));
  }
  memory.swivel = frame;
  memory.swivelled_to = to;
  KADR_TRY(set_programmable(m, memory.programmable, where));
  if (!turns || (!back && number(direction) == 0)) return {};
  Axes machine = m.position.machine;
  AxisMask named = 0;
  const RotaryPair end = to.value_or(RotaryPair());
  for (const auto& [joint, angle] : {std::pair(&rotary.first, end.first), std::pair(&rotary.second, end.second)}) {
    machine[static_cast<std::size_t>(joint->axis)] = angle;
    named |= AxisMask{1} << joint->axis;
  }
  return m.to_machine(MotionKind::rapid, machine, named, 0);
}

Result<RotaryPair> Sinumerik::rotary_positions(const BlockContext& m, Vec3 direction, Span where) const {
  const Matrix turn = product(memory.active.linear, chained(memory.swivel, memory.programmable).linear);
  const auto row = [&](std::size_t i) { return turn[i][0] * direction.x + turn[i][1] * direction.y + turn[i][2] * direction.z; };
  const Vec3 outside{row(0), row(1), row(2)};
  const auto at = [&](const RotaryJoint& joint) { return m.position.machine[static_cast<std::size_t>(joint.axis)]; };
  const auto chosen = rotary.chosen(1 / std::sqrt(dot(outside, outside)) * outside, {at(rotary.first), at(rotary.second)});
  if (!chosen) return fail(alarm(AlarmId::direction_unreachable, where, outside.x, outside.y, outside.z));
  return *chosen;
}

Status Sinumerik::transform_orientation(Emitter& m, bool on, Span where) {
  if (m.modal.radius_side != 0) return fail(alarm(AlarmId::compensation_active, where, on ? "TRAORI" : "TRAFOOF"));
  if (on && rotary.group == MachineGroup::none) return fail(alarm(AlarmId::no_five_axes, where, "TRAORI"));
  memory.holds_tip = on;
  m.change_frames();
  m.position.programmed = m.transform.to_programmed(m.position.work);
  memory.has_direction = false;
  return {};
}

}  // namespace kadr::sinumerik
