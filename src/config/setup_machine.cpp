// Keys of the set-up that describe the machine and its switches: axes, spindles, probes, overrides.

#include "config/setup_reader.h"

namespace kadr::setup_reader {
namespace {

using OptionalSpan = std::optional<std::pair<double, double>>;

Reader to_span(OptionalSpan& to) {
  return or_null([&to](const Json& item, const std::string& name) { to = least_and_most(item, name); });
}

AxisLimits axis_limits(const Json& value, const std::string& key) {
  AxisLimits axis;
  const Reader rapid = or_null([&](const Json& item, const std::string& name) {
    axis.rapid = number(item, name);
    if (!(*axis.rapid > 0)) wrong(name, "above zero");
  });
  const Reader acceleration = [&](const Json& item, const std::string& name) {
    axis.no_acceleration = item.is_null();
    if (item.is_null()) return;
    axis.acceleration = number(item, name);
    if (!(*axis.acceleration > 0)) wrong(name, "above zero, or null: without limit");
  };
  const Reader jerk_time = or_null([&](const Json& item, const std::string& name) {
    axis.jerk_time = number(item, name);
    if (!(*axis.jerk_time >= 0)) wrong(name, "zero or above");
  });
  read_table(value, key,
             {{"rapid", rapid},
              {"limits", to_span(axis.limits)},
              {"acceleration", acceleration},
              {"jerk_time", jerk_time},
              {"zone3", to_span(axis.zone3)},
              {"position_error", or_null(to_number(axis.position_error))}});
  return axis;
}

SpindleSetup spindle(const Json& value, const std::string& key) {
  SpindleSetup spindle;
  read_table(value, key,
             {{"rpm", to_number(spindle.rpm)},
              {"dir", to_one_of(spindle.dir, {"cw", "ccw", "stop"})},
              {"name", or_null(to_word(spindle.name))},
              {"channel", or_null(to_whole(spindle.channel, 1, most_channels))},
              {"angle", [&](const Json& item, const std::string& name) { spindle.angle = number_or_vacant(item, name); }},
              {"ranges", or_null([&](const Json& item, const std::string& name) { spindle.ranges = list(item, name, least_and_most); })},
              {"loop", to_one_of(spindle.loop, {"open", "closed"})},
              {"surface_speed", to_number(spindle.surface_speed)},
              {"css_axis", or_null(to_whole(spindle.css_axis, 0, most_number))},
              {"master", or_null(to_whole(spindle.master, 0, most_spindles))}});
  return spindle;
}

/// The hole; every key of it must be there.
void hole(const Json& value, const std::string& key, ProbeHole& to) {
  const Reader center = [&](const Json& item, const std::string& name) {
    read_table(item, name, {{"X", to_number(to.center_x)}, {"Y", to_number(to.center_y)}});
  };
  read_table(value, key,
             {{"center", center}, {"diameter", to_number(to.diameter)}, {"top", to_number(to.top)}, {"depth", to_number(to.depth)}});
  if (!(to.diameter > 0)) wrong(key + ".diameter", "above zero");
  if (!(to.depth >= 0)) wrong(key + ".depth", "zero or above");
}

void probe_workpiece(const Json& value, const std::string& key, Setup& setup) {
  ProbeHole probed;
  bool has_hole = false;
  const Reader read_hole = [&](const Json& item, const std::string& name) {
    hole(item, name, probed);
    has_hole = true;
  };
  read_table(value, key, {{"tip_radius", to_number(probed.tip_radius)}, {"hole", read_hole}});
  if (!has_hole && probed.tip_radius == 0) return;
  if (!has_hole) wrong(key, "a table with 'hole'");
  if (!(probed.tip_radius >= 0)) wrong(key + ".tip_radius", "zero or above");
  setup.probe_hole = probed;
}

std::optional<AxisValues> signal_position(const Json& value, const std::string& key) {
  return value.is_null() ? std::nullopt : std::optional(axis_values(value, key));
}

void overrides(const Json& value, const std::string& key, Setup& s) {
  read_table(value, key,
             {{"feed", to_number(s.feed_override)}, {"rapid", to_number(s.rapid_override)}, {"spindle", to_number(s.spindle_override)}});
  if (std::min({s.feed_override, s.rapid_override, s.spindle_override}) < 0) wrong(key, "zero or above");
}

}  // namespace

Readers readers_of_machine(Setup& s) {
  return {
      {"machine",
       [&](const Json& v, const std::string& k) {
         for (const auto& [axis, row] : table(v, k).items()) s.machine[axis] = axis_limits(row, k + "." + axis);
       }},
      {"spindle",
       [&](const Json& v, const std::string& k) {
         numbered(v, k, s.spindles, spindle, {1, most_spindles});
       }},
      {"skip", [&](const Json& v, const std::string& k) { s.skip = list(v, k, whole); }},
      {"optional_stop", to_flag(s.optional_stop)},
      {"single_block", or_null(to_flag(s.single_block))},
      {"mirror", [&](const Json& v, const std::string& k) { s.mirror = list(v, k, word); }},
      {"override", [&](const Json& v, const std::string& k) { overrides(v, k, s); }},
      {"reference_points", [&](const Json& v, const std::string& k) { numbered(v, k, s.reference_points, axis_values); }},
      {"probe",
       [&](const Json& v, const std::string& k) {
         numbered(v, k, s.probe, signal_position, {1, most_inputs});
       }},
      {"probe_workpiece", or_null([&](const Json& v, const std::string& k) { probe_workpiece(v, k, s); })},
  };
}

}  // namespace kadr::setup_reader
