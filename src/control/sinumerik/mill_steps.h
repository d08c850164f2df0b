#pragma once
// The steps of a milling cycle, and their execution (spec/sinumerik 14.5). Only src/control/sinumerik includes this file.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/tolerance.h"
#include "control/sinumerik/sinumerik.h"

namespace kadr::sinumerik {

/// The greatest number of steps of one call.
inline constexpr std::size_t most_steps = 200'000;

struct MillStep {
  enum class Kind : std::uint8_t { rapid, feed, arc_cw, arc_ccw };
  Kind kind = Kind::rapid;
  Vec2 to;
  double height = 0;
  double feed = 0;   // mm/min; 0: the feed in force
  Vec2 centre;       // arcs
  double turns = 0;  // arcs
};

class MillSteps final : public SteppedCycleValue<MillSteps> {
 public:
  explicit MillSteps(std::vector<MillStep> steps) : steps_(std::move(steps)) {}

  Result<bool> next(Emitter& m) override {
    constexpr std::size_t at_a_time = 8;
    for (std::size_t i = 0; i < at_a_time && at_ < steps_.size(); ++i) KADR_TRY(execute(m, steps_[at_++]));
    return at_ < steps_.size();
  }

 private:
  static Status execute(Emitter& m, const MillStep& step) {
    const PlaneAxes plane = m.modal.axes;
    Axes to = m.position.programmed;
    AxisMask named = 0;
    const auto set = [&](std::size_t axis, double value) {
      if (std::fabs(to[axis] - value) > tol::same_point) named |= AxisMask{1} << axis;
      to[axis] = value;
    };
    set(plane.first, step.to.x);
    set(plane.second, step.to.y);
    set(plane.normal, step.height);
    const bool is_arc_step = step.kind == MillStep::Kind::arc_cw || step.kind == MillStep::Kind::arc_ccw;
    if (named == 0 && !is_arc_step) return {};
    if (step.kind == MillStep::Kind::rapid) return m.straight(MotionKind::rapid, to, named);
    const double feed = m.modal.feed;
    const FeedMode mode = m.modal.feed_mode;
    if (step.feed > 0) m.modal.feed = step.feed, m.modal.feed_mode = FeedMode::per_minute;
    Status moved;
    if (is_arc_step) {
      const Turn turn = step.kind == MillStep::Kind::arc_cw ? Turn::cw : Turn::ccw;
      sinumerik_of(m).emit_arc(m, turn, PlaneArc{step.centre, step.turns}, to, named);
    } else {
      moved = m.straight(MotionKind::feed, to, named);
    }
    m.modal.feed = feed;
    m.modal.feed_mode = mode;
    return moved;
  }

  std::vector<MillStep> steps_;
  std::size_t at_ = 0;
};

/// Adds the depths of equal steps from `reference` down to `bottom`, none greater than `mid`; one step if `mid` is 0 (spec/sinumerik 14.5).
///   alarms  cycle_endless
inline Status add_depths(std::vector<double>& all, double reference, double bottom, double mid, Span where) {
  constexpr double most_depths = 10'000;
  const double whole = reference - bottom;
  const double count = mid > 0 ? std::max(1.0, std::ceil(whole / mid - 1e-9)) : 1;
  if (count > most_depths) return fail(alarm(AlarmId::cycle_endless, where));
  for (double i = 1; i <= count; ++i) all.push_back(reference - whole * i / count);
  return {};
}

}  // namespace kadr::sinumerik
