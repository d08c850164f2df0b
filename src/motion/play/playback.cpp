// Playback computes the axes' positions at the servo rate from the cells that the planner emits. Feed hold, resume and override are
// possible at any time. Used by out/trace/samples; tested by tests/motion/playback_test.cpp.

#include "motion/play/playback.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace kadr {
namespace {

constexpr int tries_an_instant = 25;  // Number of checked positions of the next ramp per servo period. The check takes some microseconds.
constexpr double least_places = 25;   // Smallest number of checked positions per ramp. A long ramp is checked once per servo period.
constexpr double longer = 1.15;       // factor by which each tried ramp is longer than the previous one
// Duration of the longest ramp that is tried, s. If this ramp is not allowed either, the search starts again with the shortest ramp and a
// higher jerk limit.
constexpr double longest = 20;
// A ramp may exceed the jerk limits by this fraction. If no ramp is found, the allowed excess grows by the same fraction, but at most to
// most_over.
constexpr double a_little_more = 0.005;
constexpr double most_over = 0.015;              // greatest allowed excess over the jerk limits, as a fraction of these limits
constexpr double rounding_of_limits = 1 + 1e-9;  // factor of all limits that allows for rounding errors
// Intermediate overrides (factors of the planned speed). If the plan uses the full jerk limit, playing the plan at these overrides leaves
// 2, 9, 27 and 66 % of the jerk for the change. A ramp that would take much longer than shortest() is therefore divided at one of these
// overrides. Otherwise the little jerk that is available at the start of the ramp would limit the whole change.
constexpr std::array split_shares = {0.992, 0.97, 0.9, 0.7};
constexpr double much_longer = 1.2;
constexpr double least_change = 0.001;  // smallest change of the override that is tried if too few cells are available for the check
constexpr double least_ramp = 4;        // duration of the shortest ramp, in servo periods

}  // namespace

Playback::Playback(MotionLimits limits, double rate, std::size_t cells)
    : limits_(std::move(limits)), period_(1 / rate), ring_(limits_.speed.size(), cells) {}

/// Moves the cursor by `seconds` of the servo clock. Calls `crossed(end, time on the ramp)` for each cell that ends in this time. crossed()
/// may return a delay, s, that lengthens the next cell, in which the axes are at rest. From this cell on, the plan is played at the
/// override 1.
///   returns  false if too few cells are available; the cursor is then at the end of the last cell
template <class Crossed>
bool Playback::advance(Cursor& at, const OverrideRamp& ramp, double on_ramp, double seconds, Crossed&& crossed) const {
  double left = seconds;
  double plan_seconds = ramp.passed(on_ramp + seconds) - ramp.passed(on_ramp);
  bool held = ramp.at(on_ramp + seconds).share <= 0;
  while (!is_over(at)) {
    const TimeLaw& law = ring_.law(at.cell);
    const double rest = law.seconds - at.t;
    const bool stands = law.length == 0;
    const double step = stands ? (held ? 0 : left) : plan_seconds;
    if (step < rest) {
      at.t += step;
      return true;
    }
    const double part = step > 0 ? rest / step : 0;
    left -= part * left, plan_seconds -= part * plan_seconds;
    const std::optional<double> wait = crossed(Cursor{at.cell, law.seconds}, on_ramp + seconds - left);
    ++at.cell, at.t = 0;
    if (wait) at.t = -*wait, plan_seconds = left, held = false;
  }
  return left <= 0;
}

bool Playback::advance(Cursor& at, const OverrideRamp& ramp, double on_ramp) const {
  return advance(at, ramp, on_ramp, period_, [](const Cursor&, double) { return std::nullopt; });
}

void Playback::show(const Cursor& at, double* x) {
  const bool over = is_over(at);
  const std::uint64_t cell = over ? at.cell - 1 : at.cell;
  const TimeLaw& law = ring_.law(cell);
  const double t = over ? law.seconds : at.t, s = over ? law.length : law.distance(t);
  for (std::size_t a = 0; a < ring_.axes(); ++a) {
    const double* const c = ring_.path(cell, a);
    x[a] = c[0] + s * (c[1] + s * (c[2] + s * (c[3] + s * (c[4] + s * c[5]))));
  }
  now_.tag = ring_.tag(cell);
  now_.motion = ring_.motion(cell);
  now_.spindle = ring_.spindle(cell).at(t, s) + now_.slip;
}

/// Returns true if no axis exceeds its limits at the cursor position with the override `pace`. Where the plan itself exceeds a limit, the
/// planned value replaces the limit.
bool Playback::is_allowed(const Cursor& at, const OverrideFactor& pace) const {
  if (pace.share < 0 || pace.share > rounding_of_limits) return false;
  if (is_over(at)) return true;
  const TimeLaw& law = ring_.law(at.cell);
  const TimeLaw::State i = law.after(at.t);
  for (std::size_t a = 0; a < ring_.axes(); ++a) {
    const double* const c = ring_.path(at.cell, a);
    const double x1 = c[1] + i.distance * (2 * c[2] + i.distance * (3 * c[3] + i.distance * (4 * c[4] + i.distance * 5 * c[5])));
    const double x2 = 2 * c[2] + i.distance * (6 * c[3] + i.distance * (12 * c[4] + i.distance * 20 * c[5]));
    const double x3 = 6 * c[3] + i.distance * (24 * c[4] + i.distance * 60 * c[5]);
    const double speed = x1 * i.speed, acceleration = x2 * i.speed * i.speed + x1 * i.acceleration;
    const double jerk = x3 * i.speed * i.speed * i.speed + 3 * x2 * i.speed * i.acceleration + x1 * i.jerk;
    const double now = pace.share * pace.share * acceleration + pace.rate * speed;
    const double change = pace.share * (pace.share * pace.share * jerk + 3 * pace.rate * acceleration) + pace.bend * speed;
    if (std::fabs(now) > rounding_of_limits * std::max(limits_.acceleration[a], std::fabs(acceleration))) return false;
    if (std::fabs(change) > (rounding_of_limits + now_.over) * std::max(limits_.jerk[a], std::fabs(jerk))) return false;
  }
  return true;
}

/// Returns the least time, s, in which the override may change to `target`. The time follows from the speed at the current position and
/// from the axes' limits.
double Playback::shortest(double target) const {
  double seconds = least_ramp * period_;
  if (is_over(now_.at)) return seconds;
  const TimeLaw& law = ring_.law(now_.at.cell);
  const TimeLaw::State i = law.after(now_.at.t);
  const double change = std::fabs(target - share());
  constexpr double max_rate = 1.875, most_bend = 5.77;  // the greatest first and second derivative of a ramp from 0 to 1 that takes 1 s
  for (std::size_t a = 0; a < ring_.axes(); ++a) {
    const double* const c = ring_.path(now_.at.cell, a);
    const double speed =
        change *
        std::fabs(i.speed * (c[1] + i.distance * (2 * c[2] + i.distance * (3 * c[3] + i.distance * (4 * c[4] + i.distance * 5 * c[5])))));
    seconds = std::max({seconds, max_rate * speed / limits_.acceleration[a], std::sqrt(most_bend * speed / limits_.jerk[a])});
  }
  return std::min(seconds, longest);
}

/// Starts the check of a ramp to the override `target` that takes `seconds`. The ramp will start at the servo instant at which the check is
/// complete.
void Playback::try_ramp(double target, double seconds) {
  const double places = std::max(seconds / period_, least_places);
  const auto lead = static_cast<std::uint64_t>(std::ceil(places / tries_an_instant)) + 2;
  now_.probe = now_.at;
  double on_ramp = now_.on_ramp;
  for (std::uint64_t i = 0; i < lead; ++i, on_ramp += period_) advance(now_.probe, now_.ramp, on_ramp);
  now_.next = OverrideRamp(now_.ramp.at(on_ramp), target, seconds);
  now_.begins = now_.instant + lead;
  now_.on_next = 0;
  now_.trying = true;
  now_.tried = false;
}

/// Returns the intermediate override nearest to the target, for a shorter ramp instead of the ramp under check; nullopt if no intermediate
/// override lies before the target.
std::optional<double> Playback::split_share() const {
  const double from = now_.next.at(0).share, to = now_.next.end();
  std::optional<double> nearest;
  for (const double share : split_shares)
    if ((share - from) * (share - to) < 0 && (!nearest || std::fabs(share - to) < std::fabs(*nearest - to))) nearest = share;
  return nearest;
}

/// Raises the allowed excess over the jerk limits a little and starts the search again with the shortest ramp.
void Playback::exceed_a_little() {
  now_.over = std::min(now_.over + a_little_more, most_over);
  try_ramp(now_.next.end(), shortest(now_.next.end()));
}

/// Continues the check of the next ramp. The limits are checked at the servo instants, and in a short ramp also between these instants.
/// They are also checked on both sides of each cell boundary, because the jerk jumps at a boundary.
void Playback::keep_trying() {
  const double step = std::min(period_, now_.next.seconds() / least_places);
  bool allowed = true;
  const auto look = [&](const Cursor& end, double on_ramp) -> std::optional<double> {
    const OverrideFactor pace = now_.next.at(on_ramp);
    allowed = allowed && is_allowed(end, pace) && is_allowed({end.cell + 1, 0}, pace);
    return std::nullopt;
  };
  for (int i = 0; i < tries_an_instant; ++i) {
    if (now_.on_next > now_.next.seconds()) {
      now_.tried = true;
      return;
    }
    const bool known = advance(now_.probe, now_.next, now_.on_next, step, look) || ring_.finished();
    now_.on_next += step;
    // The available cells are too few for the check. Either a little more jerk is allowed, or a smaller change is tried that fits into the
    // known cells. A further ramp then follows the smaller change.
    if (!known) {
      const bool fits = shortest(0) * share() < 2 * ahead();
      if (now_.next.end() <= 0 && now_.over < most_over && fits) return exceed_a_little();
      const double from = now_.next.at(0).share, change = (now_.next.end() - from) / 2;
      const double target = std::fabs(change) > least_change ? from + change : now_.goal;
      return try_ramp(target, shortest(target));
    }
    if (allowed && is_allowed(now_.probe, now_.next.at(now_.on_next))) continue;
    const double seconds = longer * now_.next.seconds();
    const std::optional<double> sooner = split_share();
    if (sooner && seconds > much_longer * shortest(now_.next.end())) return try_ramp(*sooner, shortest(*sooner));
    if (seconds >= longest) return exceed_a_little();
    return try_ramp(now_.next.end(), seconds);
  }
}

/// Returns the override that the operator requests, 0 to 1. In cells where the override switch has no effect, the result is 1. In cells
/// where feed hold has no effect, the last requested override above 0 replaces a request of 0.
double Playback::requested_share() {
  const double requested = requested_.load(std::memory_order_relaxed);
  if (requested > 0) now_.last_override = requested;
  if (is_over(now_.at)) return requested;
  const Switches switches = ring_.switches(now_.at.cell);
  if (requested <= 0 && switches.hold) return 0;
  return switches.feed_override ? now_.last_override : 1;
}

/// Compares the requested override with the current override, and starts, continues or ends the check of a ramp. If few cells are left, it
/// brakes the axes.
void Playback::steer() {
  const bool scarce = !ring_.finished() && ring_.has_room() && ahead() < reserve * (now_.goal > 0 ? 1 : 2);
  const double requested = scarce ? 0 : requested_share();
  if (requested != now_.goal || (!now_.trying && now_.on_ramp >= now_.ramp.seconds() && now_.ramp.end() != now_.goal)) {
    now_.goal = requested;
    now_.over = a_little_more;
    try_ramp(now_.goal, shortest(now_.goal));
  }
  if (now_.trying && !now_.tried) keep_trying();
  if (!now_.trying || now_.instant < now_.begins) return;
  if (!now_.tried) return try_ramp(now_.next.end(), now_.next.seconds());
  now_.ramp = now_.next;
  now_.on_ramp = now_.over = 0;
  now_.trying = now_.tried = false;
}

/// Returns by how many seconds longer than planned the axes must wait for the spindle angle in a cell at whose end they synchronise with
/// the spindle. The caller calls it at the start of this cell.
double Playback::wait_for_spindle(std::uint64_t cell) {
  // `turn` is one revolution in degrees; `same` is the difference in degrees below which two angles count as equal.
  constexpr double turn = 360, same = 1e-6;
  const double rate = ring_.spindle(cell).per_second, turns = std::round(now_.slip / turn);
  if (rate == 0 || std::fabs(now_.slip - turn * turns) < same) {
    now_.slip = turn * turns;
    return 0;
  }
  const double aim = turn * (rate > 0 ? std::ceil(now_.slip / turn) : std::floor(now_.slip / turn));
  const double wait = (aim - now_.slip) / rate;
  now_.slip = aim;
  return wait;
}

/// Advances axes and spindle by one servo period. Returns false if too few cells are available; step() then restores the position.
bool Playback::go_on() {
  constexpr double turn = 360;
  const bool as_planned = now_.on_ramp >= now_.ramp.seconds() && now_.ramp.end() == 1;
  const double begins = now_.on_ramp;
  // `on_plan` is the plan time and `on_clock` the time on the ramp at the start of the current cell, both in s.
  double on_plan = now_.at.t, on_clock = begins, over = 0;
  bool in_step = false;
  // Adds to `over` how far, in degrees, the spindle is ahead of its planned rotation at `to`. The spindle rotates in real time, whatever
  // the override is.
  const auto turns_on = [&](const Cursor& to, double clock) {
    if (!as_planned && !in_step) over += ring_.spindle(to.cell).per_second * ((clock - on_clock) - (to.t - on_plan));
  };
  const bool known = advance(now_.at, now_.ramp, begins, period_, [&](const Cursor& end, double clock) -> std::optional<double> {
    turns_on(end, clock);
    on_plan = 0, on_clock = clock;
    if (end.cell + 1 >= ring_.end()) return std::nullopt;
    const SpindleTurn& next = ring_.spindle(end.cell + 1);
    if (next.absolute) now_.slip = turn * std::round((now_.slip + over) / turn), over = 0;
    if (!next.awaited) return std::nullopt;
    now_.slip += over, over = 0;
    in_step = true;
    return wait_for_spindle(end.cell + 1);
  });
  if (!is_over(now_.at)) turns_on(now_.at, begins + period_);
  if (!known && !ring_.finished()) return false;
  now_.slip += over;
  now_.on_ramp += period_;
  if (in_step) {
    now_.ramp = OverrideRamp(now_.goal = 1);
    now_.on_ramp = 0;
    now_.trying = now_.tried = false;
  }
  return true;
}

void Playback::step() {
  steer();
  const Cursor before = now_.at;
  const double slip = now_.slip;
  if (!go_on()) {
    now_.at = before, now_.slip = slip;
    now_.on_ramp += period_;
    ++now_.starved;
  }
  ++now_.instant;
  for (std::uint64_t cell = before.cell; cell < now_.at.cell; ++cell) now_.played += ring_.law(cell).seconds;
  ring_.release(now_.at.cell > 0 ? now_.at.cell - 1 : 0);
}

std::size_t Playback::fill(double* positions, std::size_t count) {
  if (!now_.started) {
    const double share = requested_share();
    if (ring_.end() == 0) {
      now_.done = ring_.finished();
      return 0;
    }
    now_.ramp = OverrideRamp(now_.goal = share);
  }
  std::size_t rows = 0;
  while (rows < count && !now_.done) {
    if (now_.started) step();
    now_.started = true;
    now_.done = ring_.finished() && is_over(now_.at);
    show(now_.at, positions + rows * ring_.axes());
    ++rows;
  }
  return rows;
}

}  // namespace kadr
