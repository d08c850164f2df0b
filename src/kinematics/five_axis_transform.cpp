// Converts between work coordinates, the part and the machine axes by the rules of NCT chapter 25. Used by control/fanuc/five_axis and
// out/trace; tested by tests/kinematics/five_axis_transform_test.cpp.

#include "kinematics/five_axis_transform.h"

#include <algorithm>
#include <cmath>

namespace kadr {

bool FiveAxisTransform::is_plain() const {
  return !d_.has_frame && !d_.fixed && !d_.follows_table && !d_.moves_origin && !d_.follows_head && !d_.corrects;
}

Vec3 FiveAxisTransform::main_of(const Axes& axes) const {
  const auto of = [&](std::size_t i) { return d_.main[i] < 0 ? 0.0 : axes[static_cast<std::size_t>(d_.main[i])]; };
  return {of(0), of(1), of(2)};
}

void FiveAxisTransform::set_main(Axes& axes, Vec3 to) const {
  const double values[] = {to.x, to.y, to.z};
  for (std::size_t i = 0; i < 3; ++i)
    if (d_.main[i] >= 0) axes[static_cast<std::size_t>(d_.main[i])] = values[i];
}

RotaryPair FiveAxisTransform::rotary(const Axes& machine) const {
  const auto of = [&](int axis) { return axis < 0 ? 0.0 : machine[static_cast<std::size_t>(axis)]; };
  return {of(d_.machine.first.axis), of(d_.machine.second.axis)};
}

/// Returns the machine positions for programmed rotary positions, the nearest of all solutions (nct 25l, INFERRED). Machine and programmed
/// positions differ if the basic rotation tilts the tool together with the part.
RotaryPair FiveAxisTransform::leaned(RotaryPair machine) const {
  if (!d_.corrects) return machine;
  return d_.machine.continued(d_.basic * d_.machine.direction(machine, d_.measured), machine, d_.measured).value_or(machine);
}

RotaryPair FiveAxisTransform::untilted(RotaryPair machine) const {
  if (!d_.corrects) return machine;
  return d_.machine.continued(turned_back(d_.basic, d_.machine.direction(machine, d_.measured)), machine, d_.measured).value_or(machine);
}

/// Returns the machine position of the work origin when the table, which moves the origin, is at `at` (nct 25.4; spec/nct/25d). The origin
/// was measured with the table at `measured`.
Vec3 FiveAxisTransform::origin_at(RotaryPair at) const { return d_.machine.point_on_machine(at, d_.zero, d_.measured); }

Vec3 FiveAxisTransform::tool_at(RotaryPair at) const { return d_.follows_head ? d_.machine.length_vector(at, d_.length) : d_.length; }

/// Returns the machine position of a point. `from_zero` is the vector from the work origin to the point, and includes the basic rotation
/// already.
Vec3 FiveAxisTransform::on_machine(RotaryPair at, Vec3 from_zero) const {
  if (d_.follows_table) return d_.machine.point_on_machine(at, d_.zero + from_zero, d_.measured);
  return (d_.moves_origin ? origin_at(at) : d_.zero) + from_zero;
}

Axes FiveAxisTransform::machine_of(const Axes& work, const Axes& plainly) const {
  Axes machine = plainly;
  const RotaryPair now = leaned(rotary(plainly));
  if (d_.corrects) {
    machine[static_cast<std::size_t>(d_.machine.first.axis)] = now.first;
    machine[static_cast<std::size_t>(d_.machine.second.axis)] = now.second;
  }
  const RotaryPair at = d_.fixed.value_or(now);
  set_main(machine, on_machine(at, d_.basic * in_system(main_of(work))) + tool_at(at));
  return machine;
}

Axes FiveAxisTransform::work_of(const Axes& machine, const Axes& plainly) const {
  Axes work = plainly;
  const RotaryPair stand = rotary(machine), at = d_.fixed.value_or(stand);
  if (d_.corrects) {
    const RotaryPair back = untilted(stand);
    work[static_cast<std::size_t>(d_.machine.first.axis)] += back.first - stand.first;
    work[static_cast<std::size_t>(d_.machine.second.axis)] += back.second - stand.second;
  }
  const Vec3 tip = main_of(machine) - tool_at(at);
  const Vec3 from_zero =
      d_.follows_table ? d_.machine.point_in_part(at, tip, d_.measured) - d_.zero : tip - (d_.moves_origin ? origin_at(at) : d_.zero);
  set_main(work, in_frame(turned_back(d_.basic, from_zero)));
  return work;
}

AxisMask FiveAxisTransform::moved_with(AxisMask named) const {
  if (!d_.controls_tip && !d_.has_frame && (named & rotary_axes()) == 0) return named;
  if (d_.controls_tip && (named & (main_axes() | rotary_axes())) != 0)
    return named | main_axes() | (d_.corrects ? rotary_axes() : AxisMask{0});
  if ((named & rotary_axes()) != 0) {
    if (d_.corrects) named |= rotary_axes();
    if (moves_by_rotary() && !(d_.keeps_linear && only_rotary(named))) named |= main_axes();
  }
  return d_.has_frame && (named & main_axes()) != 0 ? named | main_axes() : named;
}

Axes FiveAxisTransform::in_system(const Axes& work) const {
  Axes system = work;
  if (d_.has_frame) set_main(system, in_system(main_of(work)));
  return system;
}

/// Returns the physical pose: the head tilts the tool length and the table rotates the part, independent of the codes in force.
Pose FiveAxisTransform::pose(const Axes& machine) const {
  const RotaryPair at = rotary(machine);
  const Vec3 tip = main_of(machine) - d_.machine.length_vector(at, d_.length);
  return {turned_back(d_.basic, d_.machine.point_in_part(at, tip, d_.measured) - d_.zero),
          turned_back(d_.basic, d_.machine.direction(at, d_.measured))};
}

std::optional<Mat3> FiveAxisTransform::turn() const {
  const Mat3 orientation = d_.basic * d_.frame;
  if (!d_.follows_table) return orientation;
  if (!d_.fixed) return std::nullopt;
  return d_.machine.table_turn(*d_.fixed, d_.measured) * orientation;
}

double FiveAxisTransform::arm(const Axes& machine) const {
  const RotaryPair at = rotary(machine);
  const Vec3 tip = main_of(machine) - d_.machine.length_vector(at, d_.length);
  double arm = 0;
  if (d_.machine.has_head()) arm = length(d_.length + d_.machine.holder) + length(d_.machine.head);
  if (d_.machine.has_table()) arm = std::max(arm, length(tip - d_.machine.table) + length(d_.machine.second_table));
  return arm;
}

}  // namespace kadr
