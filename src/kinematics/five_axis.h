#pragma once
// FiveAxis: a machine with main axes X, Y, Z at right angles and two rotary axes: both in the head, both in the table, or one in each (NCT
// 25.1, spec/nct/25a; N3200–N3224). The forward transformation computes the tool's pose in the part from the axis positions. The inverse
// transformation computes all rotary positions that give a tool direction, by a closed formula, and selects one of them (nct 25.11,
// spec/nct/25g 3). Lengths in mm, angles in degrees; rotary positions are machine positions.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "base/matrix.h"

namespace kadr {

enum class MachineGroup : std::uint8_t { none, head_head, table_table, head_table };  // values of N3200

struct RotaryJoint {
  int axis = -1;            // index of the axis in the channel
  Vec3 direction{0, 0, 1};  // unit vector along the axis of rotation, with both rotary axes at 0
  double sense = 1;         // 1: positive rotation is right-handed about `direction`; -1: left-handed (parameters RD1, RD2)
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  friend bool operator==(const RotaryJoint&, const RotaryJoint&) = default;
};

/// Positions of the first and the second rotary axis, degrees.
struct RotaryPair {
  double first = 0, second = 0;
  friend bool operator==(const RotaryPair&, const RotaryPair&) = default;
};

/// All pairs of rotary positions that give one direction of the tool.
struct RotarySolutions {
  int count = 0;  // number of valid elements of `pairs`; 0: no rotary positions give the direction
  std::array<RotaryPair, 2> pairs;
  // True if the direction is singular: the first rotary axis does not change it; `pairs` contains 0 for that axis
  bool first_free = false;
  // True if the direction is singular because the second rotary axis does not change it; `pairs` contains 0 for that axis
  bool second_free = false;
};

struct FiveAxis {
  MachineGroup group = MachineGroup::none;
  // The first joint carries the second; with head_table, the first tilts the tool and the second rotates the part
  RotaryJoint first, second;
  Vec3 tool{0, 0, 1};  // k: unit vector from the tip towards the holder, with both rotary axes at 0
  Vec3 table;          // T1: a point on the rotary axis of the table, or of the first table, machine coordinates
  Vec3 second_table;   // T2: vector from T1 to a point on the rotary axis of the second table
  Vec3 holder;         // E: vector from the gauge point to the rotary axis of the head that is nearest to the tool
  Vec3 head;           // D: vector from the second rotary axis of the head to the first rotary axis
  friend bool operator==(const FiveAxis&, const FiveAxis&) = default;

  bool first_on_table() const { return group == MachineGroup::table_table; }
  bool second_on_table() const { return group == MachineGroup::table_table || group == MachineGroup::head_table; }
  bool has_table() const { return second_on_table(); }
  bool has_head() const { return group == MachineGroup::head_head || group == MachineGroup::head_table; }
  // R1: rotation matrix of the first joint when it is at the position `at`, degrees
  Mat3 first_turn(double at) const { return Mat3::about(first.direction, first.sense * at); }
  // R2: rotation matrix of the second joint when it is at the position `at`, degrees
  Mat3 second_turn(double at) const { return Mat3::about(second.direction, second.sense * at); }

  /// Returns the rotation of the tool that the head's rotary axes cause.
  Mat3 head_turn(RotaryPair at) const;
  /// Returns the rotation of the part when the table turns from `zero`, the position in which the part was measured, to `at`.
  Mat3 table_turn(RotaryPair at, RotaryPair zero) const;
  /// Returns the tool's direction relative to the part. The part has the orientation that the rotary positions `zero` give (nct 25a 5).
  Vec3 direction(RotaryPair at, RotaryPair zero = {}) const;
  /// Returns the vector from the tip to the control point. `length` is the tool length as a vector, with both rotary axes at 0 (nct 25.2;
  /// 25a 6.1).
  Vec3 length_vector(RotaryPair at, Vec3 length) const;
  /// Returns the machine position, at the rotary positions `at`, of a point fixed to the part. `point` is its machine position when the
  /// rotary axes are at `zero` (nct 25.4; 25a 6.2). point_in_part() is the inverse.
  Vec3 point_on_machine(RotaryPair at, Vec3 point, RotaryPair zero = {}) const;
  Vec3 point_in_part(RotaryPair at, Vec3 point, RotaryPair zero = {}) const;

  /// Returns the rotary positions, each in (-180, 180], that give a direction of unit length (nct 25a 5.1).
  ///   law  direction(solutions(t).pairs[i]) == t
  RotarySolutions solutions(Vec3 direction, RotaryPair zero = {}) const;
  /// Returns the pair of rotary positions that the control selects when the rotary axes are at `present`. An axis whose position is free
  /// does not move; each other axis moves to the nearest equivalent position within its limits (nct 25g 3). INFERRED: if two pairs are
  /// equal by all rules, the control selects the pair in which the primary axis is not negative.
  ///   returns  nullopt if no rotary positions within the limits give the direction
  std::optional<RotaryPair> chosen(Vec3 direction, RotaryPair present, RotaryPair zero = {}) const;
  /// The solution for a direction near a singular one. The axis whose position is free in the singular direction stays at `present`. The
  /// other axis moves to the position in which the tool is as close to `direction` as possible. The free axis is the second one on
  /// table-table and head-table machines, otherwise the first one.
  ///   returns  the pair, and the angle in degrees between the direction of this pair and `direction`; nullopt if the other axis would
  ///            exceed its limits
  struct OneAxisMoved {
    RotaryPair at;
    double off = 0;
    bool first_stays = false;
  };
  std::optional<OneAxisMoved> with_one_axis_moved(Vec3 direction, RotaryPair present, RotaryPair zero = {}) const;
  /// Returns the pair nearest to `present` without regard to limits. With this pair, a motion continues steadily from `present`.
  std::optional<RotaryPair> continued(Vec3 direction, RotaryPair present, RotaryPair zero = {}) const;
};

}  // namespace kadr
