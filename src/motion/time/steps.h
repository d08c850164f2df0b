#pragma once
// Steps: converts the Actions of one channel, in order, to Steps for its sinks.

#include <utility>

#include "motion/time/estimate.h"

namespace kadr {

class Steps {
 public:
  /// `roles` and `clock` must outlive the Steps object.
  ///   start  position of the tool before the first action
  ///   clock  computes the time of each step; nullptr: steps have no time
  Steps(const AxisRoles& roles, ToolPosition start, TimeEstimate* clock = nullptr) : roles_(roles), at_(std::move(start)), clock_(clock) {}

  /// Passes the next action to a `sink(const Step&)`.
  ///   law  Step::from is the position after all actions given before
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
