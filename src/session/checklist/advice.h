#pragma once
// Advice: findings at which no control stops the program, but which a workshop would not accept (docs/checklist.md). The watches of this
// folder (classes that observe the steps of a run or its text) collect the findings.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "action/action.h"
#include "action/tool_position.h"

namespace kadr {

struct Advice {
  Alarm alarm;
  Origin origin;
  char address = 0;  // address of the word that the finding concerns; 0: the finding concerns the whole block
};

/// The findings in the order of the run, limited to a number that a person would read.
class Advices {
 public:
  /// `args`: the arguments of the message, as controls/alarms.toml lists them.
  template <class... Args>
  void add(AlarmId id, const Origin& origin, char address, Args... args) {
    if (all_.size() < most) all_.push_back({advice(id, {}, AlarmArg(args)...), origin, address});
  }
  void add(const Advice& one) {
    if (all_.size() < most) all_.push_back(one);
  }
  const std::vector<Advice>& all() const { return all_; }

 private:
  static constexpr std::size_t most = 1000;
  std::vector<Advice> all_;
};

/// True if this kind of motion removes material: it moves at feed. Probing, homing and dwelling do not.
inline bool is_cut(const Motion& motion) {
  return motion.kind == MotionKind::feed || is_arc(motion.kind) || motion.kind == MotionKind::spline || motion.kind == MotionKind::thread;
}

/// Start and end of a motion as the watches use them: X, Y, Z in work coordinates, mm. An axis that the control lacks is 0.
struct Ends {
  Vec3 from, to;
  bool turns;  // the motion is an arc: a full circle ends at its start, but moves
  Ends(const AxisRoles& roles, const ToolPosition& stands, const Motion& motion) : turns(is_arc(motion.kind)) {
    const auto at = [&](const Axes& axes, std::size_t i) { return roles.xyz[i] < 0 ? 0.0 : axes[static_cast<std::size_t>(roles.xyz[i])]; };
    from = {at(stands.work, 0), at(stands.work, 1), at(stands.work, 2)};
    to = {at(motion.to, 0), at(motion.to, 1), at(motion.to, 2)};
  }
  bool sideways() const { return turns || length(Vec2{to.x - from.x, to.y - from.y}) > least_way; }
  bool down() const { return to.z < from.z - least_way; }
  static constexpr double least_way = 1e-6;  // mm; a shorter travel counts as none
};

}  // namespace kadr
