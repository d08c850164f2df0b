#pragma once
// Step: an Action as the observers of a run see it, with the tool's position before it and its time. motion/time/steps creates it in one
// place for each channel, so that no observer has to track the tool or build the curve of a motion again.

#include <optional>
#include <variant>

#include "action/action.h"
#include "action/curve.h"
#include "action/motion_time.h"
#include "action/tool_position.h"

namespace kadr {

/// A view of an action; the constructor's arguments must outlive it. KeptStep is a copy without this condition.
class Step {
 public:
  Step(const AxisRoles& its_roles, const Action& its_action, const ToolPosition& before, double start = 0, const MotionTime& its_time = {},
       double still = 0)
      : roles(its_roles), action(its_action), from(before), begins(start), time(its_time), pause(still) {}
  Step(const Step&) = delete;  // the curve refers to members of this object
  Step& operator=(const Step&) = delete;

  const AxisRoles& roles;    // axes of the channel
  const Action& action;      //
  const ToolPosition& from;  // position of the tool before the action
  double begins;             // virtual time, s since the start, including waits for other channels
  MotionTime time;           // length and duration of a motion; all 0 if times are not computed
  double pause;              // duration of any other action, s

  /// Returns nullptr if the action is not a motion.
  const Motion* motion() const { return std::get_if<Motion>(&action.what); }

  /// Returns the path of the motion, which is built once, at the first call. The action must be a motion.
  const Curve& curve() const {
    if (!curve_) curve_.emplace(roles, from.work, std::get<Motion>(action.what));
    return *curve_;
  }

 private:
  mutable std::optional<Curve> curve_;
};

/// A copy of a Step that outlives its sources; for observers that lag behind the machine and forward steps later.
struct KeptStep {
  explicit KeptStep(const Step& step)
      : roles(step.roles), action(step.action), from(step.from), begins(step.begins), time(step.time), pause(step.pause) {}

  Step step() const { return {roles, action, from, begins, time, pause}; }

  AxisRoles roles;
  Action action;
  ToolPosition from;
  double begins;
  MotionTime time;
  double pause;
};

}  // namespace kadr
