#pragma once
// Steps: makes of the Actions of one channel, in order, what its sinks get.

#include <utility>

#include "motion/time/estimate.h"

namespace kadr {

class Steps {
 public:
  /// `roles`, `clock`: must outlive it.
  ///   start  where the tool stands before the first action
  ///   clock  times each step; nullptr: nobody counts
  Steps(const AxisRoles& roles, ToolPosition start, TimeEstimate* clock = nullptr) : roles_(roles), at_(std::move(start)), clock_(clock) {}

  /// Hands the next action to a `sink(const Step&)`.
  ///   law  Step::from is where all actions given before have led
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

  /// Where the tool stands now.
  const ToolPosition& position() const { return at_; }

 private:
  const AxisRoles& roles_;
  ToolPosition at_;
  TimeEstimate* clock_;
};

}  // namespace kadr
