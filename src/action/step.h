#pragma once
// Step: an Action as the observers of a run receive it, with its time and with the tool's position before the action. motion/time/steps
// creates all steps of a channel, so that no observer has to track the tool or build the curve of a motion again.

#include <optional>
#include <variant>

#include "action/action.h"
#include "action/curve.h"
#include "action/motion_time.h"
#include "action/tool_position.h"

namespace kadr {

/// An action with its time and the tool's position before it. A Step refers to the constructor's arguments, which must exist longer than
/// the Step; a KeptStep is a copy without this condition.
class Step {
 public:
  Step(const AxisRoles& its_roles, const Action& its_action, const ToolPosition& before, double start = 0, const MotionTime& its_time = {},
       double still = 0)
      : roles(its_roles), action(its_action), from(before), begins(start), time(its_time), pause(still) {}
  Step(const Step&) = delete;  // A Step cannot be copied, because its curve refers to members of the Step.
  Step& operator=(const Step&) = delete;

  const AxisRoles& roles;    // axes of the channel
  const Action& action;      //
  const ToolPosition& from;  // position of the tool before the action
  double begins;             // start time of the action in virtual time: s since the start of the run, including waits for other channels
  MotionTime time;           // length and duration of a motion; all values are 0 if times are not computed
  double pause;              // duration of an action that is not a motion, s

  /// Returns the motion of the action; nullptr if the action is not a motion.
  const Motion* motion() const { return std::get_if<Motion>(&action.what); }

  /// Returns the path of the motion, which is built at the first call. The caller must check that the action is a motion.
  const Curve& curve() const {
    if (!curve_) curve_.emplace(roles, from.work, std::get<Motion>(action.what));
    return *curve_;
  }

 private:
  mutable std::optional<Curve> curve_;
};

/// A copy of a Step that remains valid when the step's sources are gone, for observers that process steps later than the machine.
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
