#pragma once
// Advice: a finding at which no control stops the program, but which a workshop would not accept (docs/checklist.md). The watches of this
// folder collect the findings. A watch is a class that observes the steps of a run, or the text of the program.

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
  char address = 0;  // address (letter) of the word that the finding concerns; 0: the finding concerns the whole block
};

/// The findings in the order of the run. Their number is limited to what a person would read.
class Advices {
 public:
  /// Adds a finding. `args`: the arguments of its message, in the order in which controls/alarms.toml states them.
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

/// True if this kind of motion removes material, that is, if it moves at feed. Probing, homing and dwelling remove nothing.
inline bool is_cut(const Motion& motion) {
  return motion.kind == MotionKind::feed || is_arc(motion.kind) || motion.kind == MotionKind::spline || motion.kind == MotionKind::thread;
}

/// Start and end of a motion in work coordinates, mm, as the classes of this folder compare them. A coordinate is 0 if the control has no
/// such axis.
struct Ends {
  Vec3 from, to;
  bool turns;  // true: the motion is an arc. A full circle moves although its end equals its start
  Ends(const AxisRoles& roles, const ToolPosition& stands, const Motion& motion) : turns(is_arc(motion.kind)) {
    const auto at = [&](const Axes& axes, std::size_t i) { return roles.xyz[i] < 0 ? 0.0 : axes[static_cast<std::size_t>(roles.xyz[i])]; };
    from = {at(stands.work, 0), at(stands.work, 1), at(stands.work, 2)};
    to = {at(motion.to, 0), at(motion.to, 1), at(motion.to, 2)};
  }
  bool sideways() const { return turns || length(Vec2{to.x - from.x, to.y - from.y}) > least_travel; }
  bool down() const { return to.z < from.z - least_travel; }
  static constexpr double least_travel = 1e-6;  // mm; a shorter travel counts as no travel
};

}  // namespace kadr
