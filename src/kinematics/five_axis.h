#pragma once
// FiveAxis: a machine with main axes X, Y, Z at right angles and two rotary axes: both on the head, both on the table, or one on each
// (NCT 25.1, spec/nct/25a; N3200–N3224). Forward: from the axis positions to the tool's pose in the part. Inverse: all rotary
// positions that give a direction, in closed form, and the choice between them (25.11, spec/nct/25g 3). mm, degrees; rotary positions
// are machine positions.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "base/matrix.h"

namespace kadr {

enum class MachineGroup : std::uint8_t { none, head_head, table_table, head_table };  // values of N3200

struct RotaryJoint {
  int axis = -1;            // index in the channel
  Vec3 direction{0, 0, 1};  // unit length, with both rotary axes at 0
  double sense = 1;         // of a positive rotation: 1 right-handed, -1 left-handed (RD1, RD2)
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  friend bool operator==(const RotaryJoint&, const RotaryJoint&) = default;
};

/// Positions of the first and the second rotary axis.
struct RotaryPair {
  double first = 0, second = 0;
  friend bool operator==(const RotaryPair&, const RotaryPair&) = default;
};

/// All rotary positions that give one direction of the tool.
struct RotarySolutions {
  int count = 0;  // 0: the direction cannot be reached
  std::array<RotaryPair, 2> pairs;
  bool first_free = false;   // singular: every position of this axis gives the direction; `pairs` then holds 0
  bool second_free = false;  // likewise
};

struct FiveAxis {
  MachineGroup group = MachineGroup::none;
  RotaryJoint first, second;  // the first carries the second; with head_table the first turns the tool, the second the part
  Vec3 tool{0, 0, 1};         // k: from the tip into the tool, with both rotary axes at 0
  Vec3 table;                 // T1: a point on the axis of the (first) table, machine coordinates
  Vec3 second_table;          // T2: from that point to the axis of the second table
  Vec3 holder;                // E: from the gauge point to the rotary axis nearest to the tool
  Vec3 head;                  // D: from the second axis of the head to its first
  friend bool operator==(const FiveAxis&, const FiveAxis&) = default;

  bool first_on_table() const { return group == MachineGroup::table_table; }
  bool second_on_table() const { return group == MachineGroup::table_table || group == MachineGroup::head_table; }
  bool has_table() const { return second_on_table(); }
  bool has_head() const { return group == MachineGroup::head_head || group == MachineGroup::head_table; }
  Mat3 first_turn(double at) const { return Mat3::about(first.direction, first.sense * at); }     // R1
  Mat3 second_turn(double at) const { return Mat3::about(second.direction, second.sense * at); }  // R2

  /// Returns the rotation of the tool by the head.
  Mat3 head_turn(RotaryPair at) const;
  /// Returns the rotation of the part by the table since the part was measured at `zero`.
  Mat3 table_turn(RotaryPair at, RotaryPair zero) const;
  /// Returns the tool's direction in the part, as the part lies at `zero` (25a 5).
  Vec3 direction(RotaryPair at, RotaryPair zero = {}) const;
  /// Returns the vector from the tip to the control point. `length` is the tool length as a vector along `tool` (25.2; 25a 6.1).
  Vec3 length_vector(RotaryPair at, Vec3 length) const;
  /// Returns the machine position of a point of the part, which is given as its machine position at `zero` (25.4; 25a 6.2). The
  /// inverse is place_in_part().
  Vec3 place_on_machine(RotaryPair at, Vec3 point, RotaryPair zero = {}) const;
  Vec3 place_in_part(RotaryPair at, Vec3 point, RotaryPair zero = {}) const;

  /// Returns positions within one revolution, (-180, 180], for a direction of unit length (25a 5.1).
  ///   law  direction(solutions(t).pairs[i]) == t
  RotarySolutions solutions(Vec3 direction, RotaryPair zero = {}) const;
  /// Returns the pair that the control chooses, seen from the present positions. A free axis stays, and each axis goes to the nearest
  /// equivalent position within its limits (25g 3). INFERRED: if two pairs are equal by all rules, the one whose primary axis is not
  /// negative.
  ///   returns  nullopt if the direction cannot be reached
  std::optional<RotaryPair> chosen(Vec3 direction, RotaryPair present, RotaryPair zero = {}) const;
  /// Near a singular direction, the axis whose position is free there stays at `present`, and the other axis approximates the
  /// direction as well as it can. The free axis is the second on table-table and head-table machines, else the first.
  ///   returns  the pair and the error of its direction in degrees; nullopt if the other axis exceeds its limits
  struct Kept {
    RotaryPair at;
    double off = 0;
    bool first_stays = false;
  };
  std::optional<Kept> kept(Vec3 direction, RotaryPair present, RotaryPair zero = {}) const;
  /// Returns the pair nearest to `present` without regard to limits: the pair that continues the motion from there.
  std::optional<RotaryPair> continued(Vec3 direction, RotaryPair present, RotaryPair zero = {}) const;
};

}  // namespace kadr
