// LookAhead accepts Steps with their programmed times. It emits the same Steps in the same order with the times that the machine needs.
// Used by cli/run_view; tested by tests/motion/look_ahead_test.cpp.

#include "motion/look_ahead/look_ahead.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "action/by_kind.h"
#include "base/tolerance.h"

namespace kadr {
namespace {

/// Returns true for actions before which the axes stop (nct 7.0.1). INFERRED: every spindle, tool, coolant and machine function stops the
/// axes. A message stops them only if it expects an answer.
bool stops(const Action& action, const SpeedRules& rules) {
  return by_kind(
      action, same<FrameChange, ZoneChange>(rules.frames_stop), [](const Message& text) { return text.asks; },
      same<CompensationBreak, CompensationCorner, CompensationCheck, SurfaceSpeed>(false),
      same<Motion, Dwell, Spindle, Speed, CoolantSwitch, ToolSelect, ToolChange, MachineFunction, AuxiliaryFunction, Stop, Sync, Couple,
           Uncouple>(true));
}

/// Returns true for motions that keep their programmed time. The spindle of a thread or the rotary axis of polar interpolation determines
/// this time, or the programmed time is infinite, so it cannot be planned.
bool keeps_time(const Motion& motion, const MotionTime& programmed) {
  const bool polar = motion.detail && motion.detail->surface == PathSurface::polar;
  return motion.kind == MotionKind::thread || polar || !(programmed.seconds > 0);
}

bool at_rapid(const Motion& motion) { return motion.kind == MotionKind::rapid || (motion.kind == MotionKind::home && motion.feed <= 0); }

bool ends_at_rest(const Motion& motion) {
  return motion.exact || motion.in_position || motion.kind == MotionKind::probe || motion.kind == MotionKind::home;
}

}  // namespace

LookAhead::LookAhead(const AxisRoles& roles, const SpeedRules& rules, const Axes& rapid, Sink sink)
    : roles_(roles), rules_(rules), sink_(std::move(sink)) {
  for (std::size_t i = 0; i < max_axes; ++i) rapid_rates_[i] = rapid[i] / seconds_per_minute;
  if (rules.blocks) window_.emplace(roles, rules, rapid_rates_, sink_);
}

void LookAhead::consume(const Step& step) {
  if (window_) return window_->consume(step);
  if (const Motion* const m = step.motion()) {
    motion(step, *m);
  } else {
    if (stops(step.action, rules_)) rest();
    hold(step);
  }
  if (pieces_.size() >= max_pieces) plan_older();
  if (held_.size() >= max_actions) rest();
}

void LookAhead::finish() {
  if (window_) window_->finish();
  else rest();
}

LookAhead::Memory LookAhead::memory() const {
  Memory now{held_, pieces_, open_, 0, last_rapid_, 0, start_speed_, {}};
  if (window_) now.window = window_->memory();
  for (std::size_t i = 0; i < held_.size(); ++i) {
    if (open_ && open_->held == &held_[i]) now.open_at = i;
    if (last_rapid_ && last_rapid_->held == &held_[i]) now.last_rapid_at = i;
  }
  return now;
}

void LookAhead::resume_from(const Memory& memory) {
  held_ = memory.held;
  pieces_ = memory.pieces;
  open_ = memory.open;
  if (open_) open_->held = &held_[memory.open_at];
  last_rapid_ = memory.last_rapid;
  if (last_rapid_) last_rapid_->held = &held_[memory.last_rapid_at];
  start_speed_ = memory.start_speed;
  if (window_ && memory.window) window_->resume_from(*memory.window);
}

void LookAhead::hold(const Step& step) {
  if (held_.empty()) sink_(step, 0);
  else held_.push_back({KeptStep(step)});
}

void LookAhead::motion(const Step& step, const Motion& motion) {
  const Curve& curve = step.curve();
  if (!(curve.length(motion.along) > 0)) {  // The motion has the length 0: no axis moves, so no speed is planned for it.
    if (motion.exact) rest();
    return hold(step);
  }
  if (keeps_time(motion, step.time)) {
    rest();
    return hold(step);
  }
  const PathShape shape = shape_of(step);
  const bool exact = (shape.moves & ~rules_.stated) == 0;
  if (at_rapid(motion)) return rapid(step, motion, shape, exact);
  if (motion.kind == MotionKind::probe || motion.kind == MotionKind::home) rest();
  cut(step, shape, exact);
  if (ends_at_rest(motion)) rest();
}

void LookAhead::rapid(const Step& step, const Motion& motion, const PathShape& shape, bool exact) {
  const double programmed = step.time.seconds;
  RapidTime planned;
  if (rules_.overlaps_rapids) {
    Axes travel{};
    const bool led = controls_tip(step.from, motion);
    for (std::size_t i = 0; i < roles_.count; ++i)
      travel[i] = led ? motion.machine[i] - step.from.machine[i] : shape.start[i] * shape.length;
    planned = rapid_apart(rules_, travel, rapid_rates_);
  } else {
    planned = rapid_together(rules_, shape, shape.length / programmed);
  }
  if (last_rapid_ && (last_rapid_->moves & shape.moves) == 0) {
    const double ahead = std::min(last_rapid_->ahead, planned.seconds);
    last_rapid_->held->kept.time.seconds -= ahead;
    last_rapid_->held->longer -= ahead;
  }
  rest();
  Held& held = held_.emplace_back(Held{KeptStep(step), planned.seconds - programmed});
  MotionTime& time = held.kept.time;
  time.exact = exact;
  time.seconds = planned.seconds;
  time.feed_most = planned.top * seconds_per_minute;
  time.feed_end = 0;
  if (rules_.overlaps_rapids && !ends_at_rest(motion)) last_rapid_ = LastRapid{&held, shape.moves, planned.ahead};
  else rest();
}

void LookAhead::cut(const Step& step, const PathShape& shape, bool exact) {
  if (last_rapid_) rest();
  Held& held = held_.emplace_back(Held{KeptStep(step), -step.time.seconds});
  held.kept.time.exact = exact;
  Open next{&held, shape, shape.length / step.time.seconds};
  if (open_) join(next);
  open_ = next;
}

/// Determines the speed at which the open motion ends and the next motion starts (nct 7: speed of a junction).
void LookAhead::join(Open& next) {
  Open& before = *open_;
  next.bend = bend_between(before.shape, next.shape);
  next.enter = unlimited;
  if (before.motion().corner_speed != CornerSpeed::kept) {
    next.enter = std::min(junction_speed(rules_, before.shape, next.shape), speed_in_bend(rules_.normal, next.bend));
    limit_step(&next, next.bend);
  }
  if (rules_.blend) {
    const double stated = next.motion().tolerance;
    next.enter = std::min(next.enter, blend_speed(rules_, before.shape, next.shape, stated > 0 ? stated : *rules_.blend));
  }
  double slow_from = before.shape.length;
  if (is_slow_corner(rules_, before.motion(), before.shape, next.motion(), next.shape)) {
    if (before.motion().corner_speed == CornerSpeed::inner_slower) slow_from = std::max(slow_from - rules_.inner_before, 0.0);
    if (next.motion().corner_speed == CornerSpeed::inner_slower) next.slow_until = std::min(rules_.inner_after, next.shape.length);
  }
  close(slow_from);
}

/// Limits the jump of acceleration between the junction at the start of the open line and the junction at its end (nct 7.3). INFERRED: the
/// limit applies to the speed at both junctions.
void LookAhead::limit_step(Open* next, const Axes& bend) {
  const double most = speed_over_step(rules_, open_->bend, bend);
  open_->enter = std::min(open_->enter, most);
  if (next != nullptr) next->enter = std::min(next->enter, most);
}

/// Adds the open motion to the path in at most three parts. The first and the last part are the slow zones near inner corners.
void LookAhead::close(double slow_from) {
  const Open& open = *open_;
  const Acceleration acceleration = acceleration_of(rules_, open.shape);
  const auto speed = [&](double commanded) {
    return std::max(block_speed(rules_, open.motion(), open.shape, commanded), tol::least_speed);
  };
  const double fast = speed(open.commanded), slow = speed(open.commanded * rules_.inner_part);
  double enter = open.enter;
  const auto add = [&](double from, double to, double most) {
    if (!(to > from)) return;
    pieces_.push_back({to - from, most, enter, acceleration});
    enter = unlimited;
    ++open.held->pieces;
  };
  const double slow_again = std::max(slow_from, open.slow_until);
  add(0, open.slow_until, slow);
  add(open.slow_until, slow_again, fast);
  add(slow_again, open.shape.length, slow);
  open_.reset();
}

/// Plans and emits all stored steps. The axes are at rest after the last step.
void LookAhead::rest() {
  last_rapid_.reset();
  if (open_) {
    if (open_->motion().corner_speed != CornerSpeed::kept) limit_step(nullptr, {});
    close(open_->shape.length);
  }
  if (!pieces_.empty()) plan_.make(pieces_, start_speed_);
  release(pieces_.size());
  start_speed_ = 0;
}

/// Returns how many path pieces to plan now. The path is divided at the end of a motion after which the remaining path can be planned
/// separately. This is the last such end in the older half, or otherwise the first such end in the newer half. If the path has no such end,
/// the function returns the number of all pieces.
std::size_t LookAhead::place_to_part() const {
  std::size_t end = 0, best = pieces_.size();
  for (const Held& held : held_) {
    end += held.pieces;
    if (held.pieces == 0 || !pieces_[end - 1].steady) continue;
    if (end > pieces_.size() / 2 && best < pieces_.size()) break;
    best = end;
    if (end > pieces_.size() / 2) break;
  }
  return best;
}

void LookAhead::plan_older() {
  plan_.make(pieces_, start_speed_);
  const std::size_t count = place_to_part();
  start_speed_ = pieces_[count - 1].end;
  release(count);
}

/// Emits the motions that consist of the first `pieces` path pieces, and the actions that follow these motions.
void LookAhead::release(std::size_t pieces) {
  std::size_t done = 0;
  while (!held_.empty() && (done < pieces || (held_.front().pieces == 0 && !(open_ && open_->held == &held_.front())))) {
    Held& held = held_.front();
    MotionTime& time = held.kept.time;
    if (held.pieces > 0) time.seconds = time.feed_most = 0;
    for (std::size_t k = done; k < done + held.pieces; ++k) {
      time.seconds += pieces_[k].seconds;
      time.feed_most = std::max(time.feed_most, pieces_[k].top * seconds_per_minute);
      time.feed_end = pieces_[k].end * seconds_per_minute;
    }
    if (held.pieces > 0) held.longer += time.seconds;
    done += held.pieces;
    sink_(held.kept.step(), held.longer);
    held_.pop_front();
  }
  pieces_.erase(pieces_.begin(), pieces_.begin() + static_cast<std::ptrdiff_t>(pieces));
}

}  // namespace kadr
