#pragma once
// Steps converts the Actions of one channel, in their order, to Steps for the sinks of the channel.

#include <utility>

#include "motion/time/estimate.h"

namespace kadr {

class Steps {
 public:
  /// `roles` and `clock` must outlive the Steps object.
  ///   start  position of the tool before the first action
  ///   clock  computes the time of each step; nullptr: the steps have no time
  Steps(const AxisRoles& roles, ToolPosition start, TimeEstimate* clock = nullptr) : roles_(roles), at_(std::move(start)), clock_(clock) {}

  /// Converts the next action to a step and calls `sink(const Step&)` with the step.
  ///   law  Step::from is the position after all previous actions
  template <class Sink>
  void give(const Action& action, double begins, Sink&& sink) {
    Step step(roles_, action, at_, begins);
    if (clock_ != nullptr) clock_->time(step);
    sink(std::as_const(step));
    at_.take(action);
  }
  template <class Sink>
  void give(const Action& action, Sink&& sink) {
    give(action, 0, std::forward<Sink>(sink));
  }

  /// The current position of the tool.
  const ToolPosition& position() const { return at_; }

 private:
  const AxisRoles& roles_;
  ToolPosition at_;
  TimeEstimate* clock_;
};

}  // namespace kadr
