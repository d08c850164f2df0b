#pragma once
// Step: one Action as those see it who look at a run: where the tool stood before it, and when it happens. Made by motion/time/steps, in
// one place of each channel, so that none of them follows the tool for itself or builds the curve of a motion again.

#include <optional>
#include <variant>

#include "action/action.h"
#include "action/curve.h"
#include "action/motion_time.h"
#include "action/tool_position.h"

namespace kadr {

/// A view of an action: what it is made of must outlive it. KeptStep does not need that.
class Step {
 public:
  Step(const AxisRoles& its_roles, const Action& its_action, const ToolPosition& before, double start = 0, const MotionTime& its_time = {},
       double still = 0)
      : roles(its_roles), action(its_action), from(before), begins(start), time(its_time), pause(still) {}
  Step(const Step&) = delete;  // the curve points into it
  Step& operator=(const Step&) = delete;

  const AxisRoles& roles;    // of the channel
  const Action& action;      //
  const ToolPosition& from;  // where the tool stands before it
  double begins;             // virtual time, s since the start, waiting for other channels included
  MotionTime time;           // of a motion; zeros: nobody counts
  double pause;              // s, of any other action

  /// nullptr: the action is none.
  const Motion* motion() const { return std::get_if<Motion>(&action.what); }

  /// The path of the motion from there: built when it is first asked for, once.
  const Curve& curve() const {
    if (!curve_) curve_.emplace(roles, from.work, std::get<Motion>(action.what));
    return *curve_;
  }

 private:
  mutable std::optional<Curve> curve_;
};

/// A Step that outlives what it was made of: of those who run behind the machine and pass it on later.
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
