#pragma once
// FiveAxis: a machine whose main axes X, Y, Z stand at right angles and that has two rotary ones, on the head, on the table or one on each
// (NCT 25.1, spec/nct/25a; N3200–N3224). Forward: where the axes put the tool in the part. Inverse: all positions of the rotary axes for a
// direction, in closed form, and the choice between them (25.11, spec/nct/25g 3). mm, degrees; rotary positions are those of the machine.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "base/matrix.h"

namespace kadr {

enum class MachineGroup : std::uint8_t { none, head_head, table_table, head_table };  // the numbers of N3200

struct RotaryJoint {
  int axis = -1;            // by index in the channel
  Vec3 direction{0, 0, 1};  // of length 1, where both stand at 0
  double sense = 1;         // of a positive motion: 1 right-handed, -1 the other way (RD1, RD2)
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  friend bool operator==(const RotaryJoint&, const RotaryJoint&) = default;
};

/// Positions of the first and the second rotary axis.
struct RotaryPair {
  double first = 0, second = 0;
  friend bool operator==(const RotaryPair&, const RotaryPair&) = default;
};

/// All that give one direction of the tool.
struct RotarySolutions {
  int count = 0;  // 0: that direction cannot be reached
  std::array<RotaryPair, 2> pairs;
  bool first_free = false;   // singular: any position of this axis does; in `pairs` it is 0
  bool second_free = false;  //
};

struct FiveAxis {
  MachineGroup group = MachineGroup::none;
  RotaryJoint first, second;  // the first carries the second; of head_table the first turns the tool, the second the part
  Vec3 tool{0, 0, 1};         // k: from the tip into the tool where both stand at 0
  Vec3 table;                 // T1: a point of the (first) table's axis, machine coordinates
  Vec3 second_table;          // T2: from there to the second table's axis
  Vec3 holder;                // E: from the gauge point to the axis nearest to the tool
  Vec3 head;                  // D: from the second axis of the head to the first
  friend bool operator==(const FiveAxis&, const FiveAxis&) = default;

  bool first_on_table() const { return group == MachineGroup::table_table; }
  bool second_on_table() const { return group == MachineGroup::table_table || group == MachineGroup::head_table; }
  bool has_table() const { return second_on_table(); }
  bool has_head() const { return group == MachineGroup::head_head || group == MachineGroup::head_table; }
  Mat3 first_turn(double at) const { return Mat3::about(first.direction, first.sense * at); }     // R1
  Mat3 second_turn(double at) const { return Mat3::about(second.direction, second.sense * at); }  // R2

  /// How the head has turned the tool.
  Mat3 head_turn(RotaryPair at) const;
  /// How the table has turned the part since it lay on the machine as measured at `zero`.
  Mat3 table_turn(RotaryPair at, RotaryPair zero) const;
  /// Of the tool in the part, as that lies at `zero` (25a 5).
  Vec3 direction(RotaryPair at, RotaryPair zero = {}) const;
  /// From the tip to the control point; `length`: of the tool, a vector along `tool` (25.2; 25a 6.1).
  Vec3 length_vector(RotaryPair at, Vec3 length) const;
  /// Where on the machine a point of the part is that at `zero` was there (25.4; 25a 6.2). The inverse: place_in_part().
  Vec3 place_on_machine(RotaryPair at, Vec3 point, RotaryPair zero = {}) const;
  Vec3 place_in_part(RotaryPair at, Vec3 point, RotaryPair zero = {}) const;

  /// Positions within a turn, (-180, 180], for a direction of length 1 (25a 5.1).
  ///   law  direction(solutions(t).pairs[i]) == t
  RotarySolutions solutions(Vec3 direction, RotaryPair zero = {}) const;
  /// The pair that the control takes, from where the axes stand; a free axis stays, and each goes to the nearest of its equal positions
  /// within its limits (25g 3). INFERRED: of two that are equal by all rules the one whose primary axis is not negative.
  ///   returns  nothing: not to be reached
  std::optional<RotaryPair> chosen(Vec3 direction, RotaryPair present, RotaryPair zero = {}) const;
  /// Near a singular direction: the axis whose position is free there stays at `present`, the other one comes as near to the direction as
  /// it can. In a table-table machine and one with head and table the second is free, else the first.
  ///   returns  the pair and by how many degrees its direction is off; nothing: the other one's limits
  struct Kept {
    RotaryPair at;
    double off = 0;
    bool first_stays = false;
  };
  std::optional<Kept> kept(Vec3 direction, RotaryPair present, RotaryPair zero = {}) const;
  /// The pair nearest to `present`, whatever the limits: that which goes on from there.
  std::optional<RotaryPair> continued(Vec3 direction, RotaryPair present, RotaryPair zero = {}) const;
};

}  // namespace kadr
