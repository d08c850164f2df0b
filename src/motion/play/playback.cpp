// Playback: the axes' positions at the servo rate, from cells as the planner hands them out, with feed hold, resume and override at any
// moment. For out/trace/samples; tested by tests/motion/playback_test.cpp.

#include "motion/play/playback.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace kadr {
namespace {

constexpr int tries_an_instant = 25;     // instants of the next ramp looked at in one of the clock: some µs
constexpr double longer = 1.3;           // the next ramp to be tried
constexpr double longest = 20;           // s, of a ramp: longer ones are no answer; then from the shortest again
constexpr double a_little_more = 0.005;  // of the jerk: where no ramp obeyed its limit;
constexpr double most_over = 0.015;      //   at most
constexpr double rounding = 1 + 1e-9;    // of limits
constexpr double least_change = 0.001;   // of the share, for want of cells
constexpr double least_ramp = 4;         // periods

}  // namespace

Playback::Playback(MotionLimits limits, double rate, std::size_t cells)
    : limits_(std::move(limits)), period_(1 / rate), ring_(limits_.speed.size(), cells) {}

/// One instant further; `crossed(end, time on the ramp)` is told of each cell that ends on the way. It may return seconds that the next
/// one, in which the axes stand, is to be put off; the share is 1 from there on.
///   returns  false: there are not so many cells; the cursor is then at the end of the last
template <class Crossed>
bool Playback::advance(Cursor& at, const OverrideRamp& ramp, double on_ramp, Crossed&& crossed) const {
  double left = period_;  // s of the clock
  double way = ramp.passed(on_ramp + period_) - ramp.passed(on_ramp);
  bool held = ramp.at(on_ramp + period_).share <= 0;
  while (!is_over(at)) {
    const TimeLaw& law = ring_.law(at.cell);
    const double rest = law.seconds - at.t;
    const bool stands = law.length == 0;
    const double step = stands ? (held ? 0 : left) : way;
    if (step < rest) return at.t += step, true;
    const double part = step > 0 ? rest / step : 0;
    left -= part * left, way -= part * way;
    const std::optional<double> wait = crossed(Cursor{at.cell, law.seconds}, on_ramp + period_ - left);
    ++at.cell, at.t = 0;
    if (wait) at.t = -*wait, way = left, held = false;
  }
  return left <= 0;
}

bool Playback::advance(Cursor& at, const OverrideRamp& ramp, double on_ramp) const {
  return advance(at, ramp, on_ramp, [](const Cursor&, double) { return std::nullopt; });
}

void Playback::show(const Cursor& at, double* x) {
  const bool over = is_over(at);
  const std::uint64_t cell = over ? at.cell - 1 : at.cell;
  const TimeLaw& law = ring_.law(cell);
  const double t = over ? law.seconds : at.t, s = over ? law.length : law.way(t);
  for (std::size_t a = 0; a < ring_.axes(); ++a) {
    const double* const c = ring_.path(cell, a);
    x[a] = c[0] + s * (c[1] + s * (c[2] + s * (c[3] + s * (c[4] + s * c[5]))));
  }
  tag_ = ring_.tag(cell);
  spindle_ = ring_.spindle(cell).at(t, s) + slip_;
}

/// No axis exceeds at this pace what it may, or what the plan itself asks of it.
bool Playback::is_allowed(const Cursor& at, const OverrideShare& pace) const {
  if (pace.share < 0 || pace.share > rounding) return false;
  if (is_over(at)) return true;
  const TimeLaw& law = ring_.law(at.cell);
  const TimeLaw::State i = law.after(at.t);
  for (std::size_t a = 0; a < ring_.axes(); ++a) {
    const double* const c = ring_.path(at.cell, a);
    const double x1 = c[1] + i.way * (2 * c[2] + i.way * (3 * c[3] + i.way * (4 * c[4] + i.way * 5 * c[5])));
    const double x2 = 2 * c[2] + i.way * (6 * c[3] + i.way * (12 * c[4] + i.way * 20 * c[5]));
    const double x3 = 6 * c[3] + i.way * (24 * c[4] + i.way * 60 * c[5]);
    const double speed = x1 * i.speed, acceleration = x2 * i.speed * i.speed + x1 * i.acceleration;
    const double jerk = x3 * i.speed * i.speed * i.speed + 3 * x2 * i.speed * i.acceleration + x1 * i.jerk;
    const double now = pace.share * pace.share * acceleration + pace.rate * speed;
    const double change = pace.share * (pace.share * pace.share * jerk + 3 * pace.rate * acceleration) + pace.bend * speed;
    if (std::fabs(now) > rounding * std::max(limits_.acceleration[a], std::fabs(acceleration))) return false;
    if (std::fabs(change) > (rounding + over_) * std::max(limits_.jerk[a], std::fabs(jerk))) return false;
  }
  return true;
}

/// What a ramp to a share takes at least, by the speed and limits of the axes here, s.
double Playback::shortest(double target) const {
  double seconds = least_ramp * period_;
  if (is_over(at_)) return seconds;
  const TimeLaw& law = ring_.law(at_.cell);
  const TimeLaw::State i = law.after(at_.t);
  const double change = std::fabs(target - share());
  constexpr double most_rate = 1.875, most_bend = 5.77;  // of a ramp from 0 to 1 in 1 s
  for (std::size_t a = 0; a < ring_.axes(); ++a) {
    const double* const c = ring_.path(at_.cell, a);
    const double speed =
        change * std::fabs(i.speed * (c[1] + i.way * (2 * c[2] + i.way * (3 * c[3] + i.way * (4 * c[4] + i.way * 5 * c[5])))));
    seconds = std::max({seconds, most_rate * speed / limits_.acceleration[a], std::sqrt(most_bend * speed / limits_.jerk[a])});
  }
  return std::min(seconds, longest);
}

/// Begins to try a ramp to a share, of so many seconds, from the instant at which it will have been tried.
void Playback::try_ramp(double target, double seconds) {
  const auto lead = static_cast<std::uint64_t>(std::ceil(seconds / period_ / tries_an_instant)) + 2;
  probe_ = at_;
  double on_ramp = on_ramp_;
  for (std::uint64_t i = 0; i < lead; ++i, on_ramp += period_) advance(probe_, ramp_, on_ramp);
  next_ = OverrideRamp(ramp_.at(on_ramp), target, seconds);
  begins_ = instant_ + lead;
  on_next_ = 0;
  trying_ = true;
  tried_ = false;
}

/// From the shortest again.
void Playback::exceed_a_little() {
  over_ = std::min(over_ + a_little_more, most_over);
  try_ramp(next_.end(), shortest(next_.end()));
}

/// The limits are looked at at the instants and, as jerk jumps there, at both sides of each cell's end.
void Playback::go_on_trying() {
  bool allowed = true;
  const auto look = [&](const Cursor& end, double on_ramp) -> std::optional<double> {
    const OverrideShare pace = next_.at(on_ramp);
    allowed = allowed && is_allowed(end, pace) && is_allowed({end.cell + 1, 0}, pace);
    return std::nullopt;
  };
  for (int i = 0; i < tries_an_instant; ++i) {
    if (on_next_ > next_.seconds()) {
      tried_ = true;
      return;
    }
    const bool known = advance(probe_, next_, on_next_, look) || ring_.finished();
    on_next_ += period_;
    if (!known) {  // somewhat more jerk, or a smaller change that fits into what is known; from there on another
      const bool fits = shortest(0) * share() < 2 * ahead();
      if (next_.end() <= 0 && over_ < most_over && fits) return exceed_a_little();
      const double from = next_.at(0).share, change = (next_.end() - from) / 2;
      const double target = std::fabs(change) > least_change ? from + change : goal_;
      return try_ramp(target, shortest(target));
    }
    if (allowed && is_allowed(probe_, next_.at(on_next_))) continue;
    const double seconds = longer * next_.seconds();
    if (seconds >= longest) return exceed_a_little();
    return try_ramp(next_.end(), seconds);
  }
}

/// The share that the operator asks for, as far as the switches act here.
double Playback::asked() {
  const double wanted = wanted_.load(std::memory_order_relaxed);
  if (wanted > 0) last_override_ = wanted;
  if (is_over(at_)) return wanted;
  const Switches switches = ring_.switches(at_.cell);
  if (wanted <= 0 && switches.hold) return 0;
  return switches.feed_override ? last_override_ : 1;
}

/// Sees to the share that is wanted.
void Playback::steer() {
  const bool scarce = !ring_.finished() && ring_.has_room() && ahead() < reserve * (goal_ > 0 ? 1 : 2);
  const double wanted = scarce ? 0 : asked();
  if (wanted != goal_ || (!trying_ && on_ramp_ >= ramp_.seconds() && ramp_.end() != goal_)) {
    goal_ = wanted;
    over_ = 0;
    try_ramp(goal_, shortest(goal_));
  }
  if (trying_ && !tried_) go_on_trying();
  if (!trying_ || instant_ < begins_) return;
  if (!tried_) return try_ramp(next_.end(), next_.seconds());
  ramp_ = next_;
  on_ramp_ = over_ = 0;
  trying_ = tried_ = false;
}

/// A cell begins at whose end the axes go in step with the spindle: how much longer it must turn, s.
double Playback::wait_for_spindle(std::uint64_t cell) {
  constexpr double turn = 360, same = 1e-6;  // degrees
  const double rate = ring_.spindle(cell).per_second, turns = std::round(slip_ / turn);
  if (rate == 0 || std::fabs(slip_ - turn * turns) < same) return slip_ = turn * turns, 0;
  const double aim = turn * (rate > 0 ? std::ceil(slip_ / turn) : std::floor(slip_ / turn));
  const double wait = (aim - slip_) / rate;
  return slip_ = aim, wait;
}

/// One instant further, axes and spindle.
bool Playback::go_on() {
  constexpr double turn = 360;
  const bool as_planned = on_ramp_ >= ramp_.seconds() && ramp_.end() == 1;
  const double begins = on_ramp_;
  double on_plan = at_.t, on_clock = begins, over = 0;  // s; where the cell was begun
  bool in_step = false;
  const auto turns_on = [&](const Cursor& to, double clock) {  // it turns by the clock, not by the plan
    if (!as_planned && !in_step) over += ring_.spindle(to.cell).per_second * ((clock - on_clock) - (to.t - on_plan));
  };
  const bool known = advance(at_, ramp_, begins, [&](const Cursor& end, double clock) -> std::optional<double> {
    turns_on(end, clock);
    on_plan = 0, on_clock = clock;
    if (end.cell + 1 >= ring_.end()) return std::nullopt;
    const SpindleTurn& next = ring_.spindle(end.cell + 1);
    if (next.absolute) slip_ = turn * std::round((slip_ + over) / turn), over = 0;
    if (!next.awaited) return std::nullopt;
    slip_ += over, over = 0;
    in_step = true;
    return wait_for_spindle(end.cell + 1);
  });
  if (!is_over(at_)) turns_on(at_, begins + period_);
  if (!known && !ring_.finished()) return false;
  slip_ += over;
  on_ramp_ += period_;
  if (in_step) {
    ramp_ = OverrideRamp(goal_ = 1);
    on_ramp_ = 0;
    trying_ = tried_ = false;
  }
  return true;
}

void Playback::step() {
  steer();
  const Cursor before = at_;
  const double slip = slip_;
  if (!go_on()) {
    at_ = before, slip_ = slip;
    on_ramp_ += period_;
    ++starved_;
  }
  ++instant_;
  for (std::uint64_t cell = before.cell; cell < at_.cell; ++cell) played_ += ring_.law(cell).seconds;
  ring_.release(at_.cell > 0 ? at_.cell - 1 : 0);
}

std::size_t Playback::fill(double* positions, std::size_t count) {
  if (!started_) {
    const double share = asked();
    if (ring_.end() == 0) {
      done_ = ring_.finished();
      return 0;
    }
    ramp_ = OverrideRamp(goal_ = share);
  }
  std::size_t rows = 0;
  while (rows < count && !done_) {
    if (started_) step();
    started_ = true;
    done_ = ring_.finished() && is_over(at_);
    show(at_, positions + rows * ring_.axes());
    ++rows;
  }
  return rows;
}

}  // namespace kadr
