#pragma once
// FiveAxisTransform: converts between work coordinates, the part and the machine, if the programming frame is rotated in space (G68.1,
// G68.2) or if rotary axes carry the tool or the part (NCT 25). It also reports which axes move along with the programmed axes
// (spec/nct/25a 6.3). The machine position m of a programmed point p is
//   m = point_on_machine(W + B·(v0 + R·(S + p))) + V     with those terms only that the active codes require.
// V is the vector from the tip to the control point. FiveAxisTransformData below defines the other symbols.

#include <optional>

#include "action/placement.h"
#include "kinematics/five_axis.h"

namespace kadr {

/// The data that define a FiveAxisTransform. Two transforms with equal data are equal.
struct FiveAxisTransformData {
  FiveAxis machine;
  std::array<std::int8_t, 3> main{0, 1, 2};  // indices of the axes X, Y, Z in the channel; -1: the axis is missing
  Vec3 zero;            // W: work origin, machine coordinates, with the shift that was in force before the frame was set
  RotaryPair measured;  // positions of the tables when W was measured; 0 for a rotary axis of the head (nct 25a 7)
  Mat3 basic;           // B: basic rotation of the work system (nct 10.2.3, 25l)
  Mat3 frame;           // R: rotation of the programming frame by G68.1, G68.2
  Vec3 frame_origin;    // v0: origin of the programming frame
  Vec3 shift;           // S: shift by G52, G92 since the frame was set
  Vec3 length;          // vector of the tool length, from the tip, with both rotary axes at 0
  bool has_frame = false;
  bool follows_table = false;  // true if the work origin and the axis directions rotate with the table
  bool moves_origin = false;   // true if only the work origin, not the axis directions, rotates with the table (G54.2)
  bool follows_head = false;   // true if the vector of the tool length tilts with the head
  bool controls_tip = false;   // true under tool centre point control (G43.4): the tip follows the path at every point of a motion
  bool keeps_linear = false;   // true if X, Y, Z do not move in a motion that programs only rotary axes (N3212 FOS)
  bool corrects = false;       // true if the basic rotation tilts the tool too (N3212 BSE), because both rotary axes have been positioned
  // Rotary positions that the computation uses instead of the actual positions (G53.1); nullopt: the actual ones
  std::optional<RotaryPair> fixed;
  friend bool operator==(const FiveAxisTransformData&, const FiveAxisTransformData&) = default;
};

class FiveAxisTransform final : public WorkTransform {
 public:
  explicit FiveAxisTransform(const FiveAxisTransformData& data) : d_(data) {}
  const FiveAxisTransformData& data() const { return d_; }

  bool is_plain() const override;
  bool controls_tip() const override { return d_.controls_tip; }
  Axes machine_of(const Axes& work, const Axes& plainly) const override;
  Axes work_of(const Axes& machine, const Axes& plainly) const override;
  AxisMask moved_with(AxisMask named) const override;
  bool changes_work(AxisMask named) const override { return d_.keeps_linear && moves_by_rotary() && only_rotary(named); }
  Axes in_system(const Axes& work) const override;
  Vec3 zero() const override { return d_.zero; }
  bool has_frame() const override { return d_.has_frame; }
  Pose pose(const Axes& machine) const override;
  bool has_rotary() const override { return d_.machine.group != MachineGroup::none; }
  double arm(const Axes& machine) const override;
  AxisMask rotary_axes() const override { return bit(d_.machine.first.axis) | bit(d_.machine.second.axis); }

  /// in_system() converts a point from the programming frame to the work system. in_frame() is the inverse of in_system().
  Vec3 in_system(Vec3 programmed) const { return d_.frame_origin + d_.frame * (d_.shift + programmed); }
  Vec3 in_frame(Vec3 system) const { return turned_back(d_.frame, system - d_.frame_origin) - d_.shift; }
  /// Returns the rotation from the programming frame to the directions of the machine axes; nullopt if it depends on the rotary axes'
  /// positions.
  std::optional<Mat3> turn() const;
  /// length_now() returns the vector from the tip to the control point in machine directions, for the given axis positions. origin_now()
  /// returns the origin of the work system in machine coordinates, for the same axis positions.
  Vec3 length_now(const Axes& machine) const { return tool_at(d_.fixed.value_or(rotary(machine))); }
  Vec3 origin_now(const Axes& machine) const {
    return d_.moves_origin || d_.follows_table ? origin_at(d_.fixed.value_or(rotary(machine))) : d_.zero;
  }
  /// Returns the machine positions of the two rotary axes.
  RotaryPair rotary(const Axes& machine) const;
  /// Returns the tool's direction in the work system that programmed rotary positions give (nct 25l).
  Vec3 direction_of(RotaryPair programmed) const { return d_.machine.direction(programmed, d_.measured); }

 private:
  static AxisMask bit(int axis) { return axis < 0 ? 0 : AxisMask{1} << static_cast<unsigned>(axis); }
  AxisMask main_axes() const { return bit(d_.main[0]) | bit(d_.main[1]) | bit(d_.main[2]); }
  bool moves_by_rotary() const { return !d_.fixed && (d_.follows_table || d_.moves_origin || d_.follows_head); }
  bool only_rotary(AxisMask named) const { return (named & rotary_axes()) != 0 && (named & main_axes()) == 0; }
  Vec3 main_of(const Axes& axes) const;
  void set_main(Axes& axes, Vec3 to) const;
  RotaryPair leaned(RotaryPair machine) const;
  RotaryPair untilted(RotaryPair machine) const;
  Vec3 origin_at(RotaryPair at) const;
  Vec3 tool_at(RotaryPair at) const;
  Vec3 on_machine(RotaryPair at, Vec3 from_zero) const;

  FiveAxisTransformData d_;
};

}  // namespace kadr
