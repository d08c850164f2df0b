// This file collects the limits of the path speed other than the programmed feed: the accelerations of the machine, and the parameters of
// controls that have them (NCT 4.1, 6.2–6.4, 7). Used by motion/look_ahead/control_speed; tested by tests/motion/speed_rules_test.cpp.

#include "motion/look_ahead/speed_rules.h"

#include <algorithm>

#include "config/setup/setup_parameters.h"

namespace kadr {
namespace {

/// Returns the limit, or `unlimited` for the value 0. INFERRED: the value 0 switches a limit off (nct 7.3).
double limit(double value) { return value > 0 ? value : unlimited; }
double feed_limit(double per_minute) { return limit(per_minute / seconds_per_minute); }

struct AxisAcceleration {
  bool stated = false;
  double most = unlimited;  // greatest acceleration, mm/s² or degrees/s²
  double build_up = 0;      // time until the acceleration is reached, s
};

/// Returns an axis' acceleration from the set-up or from the machine profile. Only this function chooses between these two sources.
AxisAcceleration acceleration_of(const Setup& setup, const std::string& axis, const MachineProfile& profile) {
  AxisAcceleration found;
  // The set-up's entry for the axis itself is read last, so it overrides the entry "*" for all axes.
  for (const std::string& name : {std::string("*"), axis}) {
    const auto row = setup.machine.find(name);
    if (row == setup.machine.end()) continue;
    const AxisLimits& limits = row->second;
    if (limits.no_acceleration) found = {true, unlimited, found.build_up};
    if (limits.acceleration) found = {true, *limits.acceleration, found.build_up};
    if (limits.jerk_time) found.build_up = *limits.jerk_time;
  }
  if (found.stated || profile.planner != PlannerMode::control) return found;
  const auto row = profile.axes.find(axis);
  const AxisProfile own = row == profile.axes.end() ? AxisProfile{} : row->second;
  return {true, own.acceleration, found.build_up > 0 ? found.build_up : own.acceleration / own.jerk};
}

bool limits_something(const Axes& axes) {
  return std::any_of(axes.begin(), axes.end(), [](double value) { return value < unlimited; });
}

void obey_axis(SpeedRules& rules, const SetupParameters& given, std::size_t axis) {
  rules.max_feed[axis] = feed_limit(given.of_axis("0305", axis));
  rules.axis_change[axis] = feed_limit(given.of_axis("0309", axis));
  rules.normal[axis] = limit(given.of_axis("0402", axis));
  rules.line_step[axis] = limit(given.of_axis("0403", axis));
  rules.arc_step[axis] = limit(given.of_axis("0404", axis));
}

}  // namespace

bool SpeedRules::accelerates() const { return limits_something(acceleration); }

SpeedRules speed_rules(const Setup& setup, const std::vector<std::string>& axes, const MachineProfile& profile) {
  SpeedRules rules;
  for (std::size_t a = 0; a < std::min(axes.size(), max_axes); ++a) {
    const AxisAcceleration own = acceleration_of(setup, axes[a], profile);
    if (own.stated) rules.stated |= AxisMask{1} << a;
    rules.acceleration[a] = own.most;
    rules.build_up[a] = own.build_up;
  }
  rules.in_force = rules.accelerates();
  return rules;
}

bool plan_by_blocks(SpeedRules& rules, const Setup& setup, const ControlDef& control) {
  const auto value_of = [&](const char* meaning) -> std::optional<double> {
    for (const ParameterRow& row : control.parameters) {
      if (row.means.empty() || row.means.front() != meaning) continue;
      const auto stated = setup.parameters.find(ParameterKey{row.name, {}, {}});
      const double* const number = stated == setup.parameters.end() ? nullptr : std::get_if<double>(&stated->second);
      return number != nullptr ? *number : row.initial;
    }
    return std::nullopt;
  };
  const auto deviation = value_of("junction_deviation");
  if (!deviation) return false;
  BlockPlanner& blocks = rules.blocks.emplace();
  blocks.junction_deviation = *deviation;
  blocks.arc_tolerance = value_of("arc_tolerance").value_or(blocks.arc_tolerance);
  return true;
}

void obey_parameters(SpeedRules& rules, const Setup& setup, const std::vector<std::string>& axes) {
  const SetupParameters given(setup, axes);
  for (std::size_t a = 0; a < std::min(axes.size(), max_axes); ++a) obey_axis(rules, given, a);
  rules.jerk_free = given.of_channel("0421", {1, "JRK"});
  rules.by_axis_change = given.of_channel("0306", {0, "FDF"});
  rules.corner_angle = given.of_channel("0307");
  rules.corner_feed = feed_limit(given.of_channel("0308"));
  rules.least_arc_feed = given.of_channel("0310") / seconds_per_minute;
  rules.least_arc_part = std::clamp(given.of_channel("1406"), 0.0, 1.0);
  rules.inner_before = std::max(given.of_channel("1407"), 0.0);
  rules.inner_after = std::max(given.of_channel("1408"), 0.0);
  rules.inner_angle = given.of_channel("1409");
  if (const double part = given.of_channel("1410"); part > 0) rules.inner_part = std::min(part, 1.0);
  // INFERRED: the bit ROL, which lets rapid motions overlap, belongs to the parameter N0421 (NCT 4.1.1)
  rules.overlaps_rapids = given.of_channel("0421", {0, "ROL"});
  rules.overlap_from = std::clamp(given.of_channel("0422") / 100, 0.0, 1.0);
  const bool corners = rules.by_axis_change ? limits_something(rules.axis_change) : rules.corner_feed < unlimited;
  const bool zones = rules.inner_part < 1 && rules.inner_angle > 0;
  rules.in_force = rules.in_force || rules.stated != 0 || corners || zones || rules.least_arc_part > 0 ||
                   limits_something(rules.max_feed) || limits_something(rules.normal) || limits_something(rules.line_step) ||
                   limits_something(rules.arc_step);
  rules.slows_inner_arcs = rules.frames_stop = rules.in_force;
}

}  // namespace kadr
