#include "motion/axis_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/tolerance.h"
#include "path/machine_path.h"

namespace kadr {
namespace {

constexpr double shortest_rise = 1e-3;          // s, of acceleration that rises at once: one servo period
constexpr double unlimited_acceleration = 1e6;  // mm/s²: 100 g
constexpr double chord_of_tolerance = 0.04;     // an arc as chords a tenth as long as the roundings of their corners are wide

/// The setup's entry of the axis, else the one for all axes.
const AxisLimits* of_axis(const Setup& setup, const std::string& axis) {
  for (const std::string& name : {axis, std::string("*")})
    if (const auto found = setup.machine.find(name); found != setup.machine.end()) return &found->second;
  return nullptr;
}

/// Actions during which the axes stand (nct 7.0.1: the motion stops where a function is carried out behind it). Words that only set
/// something – speed, coolant, tool to be brought, message – do not.
bool needs_rest(const Action& action) {
  return std::holds_alternative<Dwell>(action.what) || std::holds_alternative<Stop>(action.what) ||
         std::holds_alternative<ToolChange>(action.what) || std::holds_alternative<Sync>(action.what) ||
         std::holds_alternative<Spindle>(action.what) || std::holds_alternative<MachineFunction>(action.what);
}

}  // namespace

MotionLimits motion_limits(const MachineProfile& profile, const Setup& setup, const std::vector<std::string>& axes) {
  constexpr double per_second = 1.0 / 60;
  MotionLimits limits;
  Setup at_full_rate = setup;  // the override slows rapid motions (their programmed time), not what the axes can do
  at_full_rate.rapid_override = 100;
  const Rates rates = rates_of(profile, at_full_rate, axes);
  for (std::size_t i = 0; i < std::min(axes.size(), max_axes); ++i) {
    const auto found = profile.axes.find(axes[i]);
    const AxisProfile own = found == profile.axes.end() ? AxisProfile{} : found->second;
    const AxisLimits* const stated = of_axis(setup, axes[i]);
    double acceleration = own.acceleration, jerk = own.jerk;
    if (stated != nullptr && stated->acceleration) {
      acceleration = *stated->acceleration;
      const double rising = stated->jerk_time.value_or(own.acceleration / own.jerk);
      jerk = acceleration / std::max(rising, shortest_rise);
    }
    if (stated != nullptr && stated->no_acceleration) acceleration = unlimited_acceleration, jerk = acceleration / shortest_rise;
    limits.speed.push_back(rates.rapid[i] * per_second);
    limits.acceleration.push_back(acceleration);
    limits.jerk.push_back(jerk);
  }
  return limits;
}

AxisMotion::AxisMotion(const AxisRoles& roles, MotionLimits limits, double tolerance, const ToolPosition& start, Planner::Sink sink)
    : roles_(roles), tolerance_(tolerance), position_(start), sink_(sink), planner_(std::move(limits), std::move(sink)) {
  planner_.begin(position_.machine.data());
}

void AxisMotion::wait(double seconds, Spent spent) {
  planner_.stop();
  if (!(seconds > 0)) return;
  TimedCells still{roles_.count, {TimeLaw{seconds, 0, true, 0, 0, 0}}, {{spent.tag()}}, {}};
  for (std::size_t a = 0; a < roles_.count; ++a) still.path.insert(still.path.end(), {position_.machine[a], 0, 0, 0, 0, 0});
  sink_(still);
}

void AxisMotion::take(const Action& action, const MotionTime& programmed, double pause) {
  if (const auto* const motion = std::get_if<Motion>(&action.what)) {
    take(*motion, programmed, action.origin);
  } else if (pause > 0 || needs_rest(action)) {
    wait(pause,
         {std::holds_alternative<Dwell>(action.what) ? Spent::On::dwell : Spent::On::tool_change, action.origin.line, action.origin.file});
    exact_ = true;
  }
  position_.take(action);
}

void AxisMotion::take(const Motion& motion, const MotionTime& programmed, const Origin& origin) {
  const MachinePath path(roles_, position_, motion);
  const bool rapid = motion.kind == MotionKind::rapid || motion.kind == MotionKind::home;
  const bool stops = motion.exact || motion.kind == MotionKind::home || motion.kind == MotionKind::probe;
  const double tolerance = motion.tolerance > 0 ? motion.tolerance : tolerance_;
  const double rounding = stops || tolerance <= 0 ? tol::exact_path : tolerance;  // between the chords of a curve
  const double junction = exact_ ? 0 : tolerance;
  const int pieces = Curve(roles_, position_.work, motion).pieces(chord_of_tolerance * rounding);
  const auto point = [&](int i) { return path.at(static_cast<double>(i) / pieces); };
  double length = 0;
  Axes last = position_.machine;
  for (int i = 1; i <= pieces; ++i) {
    const Axes to = point(i);
    double squares = 0;
    for (std::size_t a = 0; a < roles_.count; ++a) squares += (to[a] - last[a]) * (to[a] - last[a]);
    length += std::sqrt(squares);
    last = to;
  }
  way_ += length;
  if (on_motion) on_motion(way_);
  const double feed = programmed.seconds > 0 ? length / programmed.seconds : unlimited_feed;
  const std::uint64_t tag = Spent{rapid ? Spent::On::rapid : Spent::On::cutting, origin.line, origin.file}.tag();
  for (int i = 1; i <= pieces; ++i) planner_.line_to(point(i).data(), feed, i == 1 ? junction : rounding, i > 1, tag);
  exact_ = stops;
  if (stops) planner_.stop();
}

}  // namespace kadr
