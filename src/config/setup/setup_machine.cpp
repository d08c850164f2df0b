// Reads keys of the set-up for the machine and its switches: axes, spindles, probes, overrides.

#include "config/setup/setup_reader.h"

namespace kadr::setup_reader {
namespace {

using OptionalSpan = std::optional<std::pair<double, double>>;

Reader to_span(OptionalSpan& to) {
  return or_null([&to](const Json& item, const std::string& name) {
    to = limit_pair(item, name);
    const bool fits = is_within(to->first, ranges::position) && is_within(to->second, ranges::position) && to->first < to->second;
    if (!fits) wrong(name, "[least, most], the second above the first, each " + range_in_words(ranges::position));
  });
}

AxisLimits axis_limits(const Json& value, const std::string& key) {
  AxisLimits axis;
  const Reader rapid = or_null([&](const Json& item, const std::string& name) { axis.rapid = within(item, name, ranges::rate); });
  const Reader acceleration = [&](const Json& item, const std::string& name) {
    axis.no_acceleration = item.is_null();
    if (item.is_null()) return;
    if (!item.is_number() || !is_within(item.get<double>(), ranges::acceleration))
      wrong(name, range_in_words(ranges::acceleration) + ", or null: without limit");
    axis.acceleration = item.get<double>();
  };
  const Reader jerk_time =
      or_null([&](const Json& item, const std::string& name) { axis.jerk_time = within(item, name, ranges::seconds); });
  read_table(value, key,
             {{"rapid", rapid},
              {"limits", to_span(axis.limits)},
              {"acceleration", acceleration},
              {"jerk_time", jerk_time},
              {"zone3", to_span(axis.zone3)},
              {"switches", to_span(axis.switches)},
              {"apart", or_null([&](const Json& item, const std::string& name) { axis.apart = within(item, name, ranges::distance); })},
              {"position_error", or_null(to_range(axis.position_error, ranges::distance))}});
  return axis;
}

SpindleSetup spindle(const Json& value, const std::string& key) {
  SpindleSetup spindle;
  read_table(value, key,
             {{"rpm", to_range(spindle.rpm, ranges::speed)},
              {"dir", to_one_of(spindle.dir, {"cw", "ccw", "stop"})},
              {"name", or_null(to_word(spindle.name))},
              {"channel", or_null(to_whole(spindle.channel, 1, max_channels))},
              {"angle", [&](const Json& item, const std::string& name) { spindle.angle = number_or_vacant(item, name); }},
              {"ranges", or_null([&](const Json& item, const std::string& name) { spindle.ranges = list(item, name, limit_pair); })},
              {"loop", to_one_of(spindle.loop, {"open", "closed"})},
              {"surface_speed", to_range(spindle.surface_speed, ranges::speed)},
              {"css_axis", or_null(to_whole(spindle.css_axis, 0, max_number))},
              {"master", or_null(to_whole(spindle.master, 0, max_spindles))}});
  return spindle;
}

/// Reads the id of a warning or note that is not to be reported.
AlarmId finding(const Json& value, const std::string& key) {
  const AlarmId id = alarm_named(word(value, key));
  if (id == AlarmId::count) wrong(key, "the id of a warning or note");
  return id;
}

/// Reads the keys of the hole that the probe touches. All these keys are required.
void hole(const Json& value, const std::string& key, ProbeHole& to) {
  const Reader center = [&](const Json& item, const std::string& name) {
    read_table(item, name, {{"X", to_range(to.center_x, ranges::position)}, {"Y", to_range(to.center_y, ranges::position)}});
  };
  read_table(value, key,
             {{"center", center},
              {"diameter", to_range(to.diameter, ranges::diameter)},
              {"top", to_range(to.top, ranges::position)},
              {"depth", to_range(to.depth, ranges::distance)}});
  // The diameter stays 0 if the set-up does not state it, and a hole without a diameter is a fault
  if (to.diameter == 0) wrong(key + ".diameter", range_in_words(ranges::diameter));
}

void probe_workpiece(const Json& value, const std::string& key, Setup& setup) {
  ProbeHole probed;
  bool has_hole = false;
  const Reader read_hole = [&](const Json& item, const std::string& name) {
    hole(item, name, probed);
    has_hole = true;
  };
  read_table(value, key, {{"tip_radius", to_range(probed.tip_radius, ranges::distance)}, {"hole", read_hole}});
  if (!has_hole && probed.tip_radius == 0) return;
  if (!has_hole) wrong(key, "a table with 'hole'");
  setup.probe_hole = probed;
}

std::optional<AxisValues> signal_position(const Json& value, const std::string& key) {
  return value.is_null() ? std::nullopt : std::optional(axis_values(value, key));
}

void kinematics(const Json& value, const std::string& key, KinematicsSetup& to) {
  const auto vector = [&](const Json& v, const std::string& k) {
    const std::vector<double> parts = list(v, k, number);
    if (parts.size() != 3) wrong(k, "three numbers, along X, Y and Z");
    to.vectors[k.substr(k.rfind('.') + 1)] = parts;
  };
  read_table(value, key,
             {{"type", [&](const Json& v, const std::string& k) { to.type = word(v, k); }},
              {"axes", [&](const Json& v, const std::string& k) { to.axes = word(v, k); }},
              {"reversed", [&](const Json& v, const std::string& k) { to.reversed = word(v, k); }},
              {"singular", to_range(to.singular, ranges::singular)},
              {"T1", vector},
              {"T2", vector},
              {"E", vector},
              {"D", vector}});
}

/// Reads an answer of the operator; "yes" means that the block is skipped.
bool skips(const Json& value, const std::string& key) {
  const std::string answer = word(value, key);
  if (answer != "yes" && answer != "no") wrong(key, "\"yes\" or \"no\"");
  return answer == "yes";
}

void overrides(const Json& value, const std::string& key, Setup& s) {
  read_table(value, key,
             {{"feed", to_range(s.feed_override, ranges::percent)},
              {"rapid", to_range(s.rapid_override, ranges::percent)},
              {"spindle", to_range(s.spindle_override, ranges::percent)}});
}

Reader to_position(std::optional<double>& to) {
  return [&to](const Json& v, const std::string& k) { to = v.is_null() ? std::nullopt : std::optional(within(v, k, ranges::position)); };
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
         numbered(v, k, s.spindles, spindle, {1, max_spindles});
       }},
      {"skip", [&](const Json& v, const std::string& k) { s.skip = list(v, k, whole); }},
      {"skip_answers", [&](const Json& v, const std::string& k) { s.skip_answers = list(v, k, skips); }},
      {"disable", [&](const Json& v, const std::string& k) { s.disabled = list(v, k, finding); }},
      {"optional_stop", to_flag(s.optional_stop)},
      {"single_block", or_null(to_flag(s.single_block))},
      {"mirror", [&](const Json& v, const std::string& k) { s.mirror = list(v, k, word); }},
      {"override", [&](const Json& v, const std::string& k) { overrides(v, k, s); }},
      {"reference_points", [&](const Json& v, const std::string& k) { numbered(v, k, s.reference_points, axis_values); }},
      {"probe",
       [&](const Json& v, const std::string& k) {
         numbered(v, k, s.probe, signal_position, {1, max_inputs});
       }},
      {"kinematics", or_null([&](const Json& v, const std::string& k) { kinematics(v, k, s.kinematics); })},
      {"chuck_face", to_position(s.chuck_face)},
      {"tailstock", to_position(s.tailstock)},
      // setup_blank() reads these two: a run does not need them
      {"stock", or_null([](const Json& v, const std::string& k) { (void)word(v, k); })},
      {"fixtures", or_null([](const Json& v, const std::string& k) { (void)list(v, k, word); })},
      {"probe_workpiece", or_null([&](const Json& v, const std::string& k) { probe_workpiece(v, k, s); })},
  };
}

/// Sets the parameters that correspond to `kinematics` (nct 25.1, spec/nct/25a). A parameter that the set-up states itself takes
/// precedence.
void give_kinematics(Setup& setup) {
  const KinematicsSetup& k = setup.kinematics;
  if (k.type.empty() || k.axes.size() != 2) return;
  const auto give = [&](const std::string& number, const std::string& bit, double value) {
    setup.parameters.emplace(ParameterKey{number, "", bit}, value);
  };
  const std::string types[] = {"head-head", "table-table", "head-table"};
  give("3200", "", static_cast<double>(std::find(std::begin(types), std::end(types), k.type) - types + 1));
  give("3201", "", 3);
  for (int n = 0; n < 2; ++n) {
    const std::string letter(1, k.axes[static_cast<std::size_t>(n)]);
    const auto at = std::find(setup.axes.begin(), setup.axes.end(), letter);
    if (at == setup.axes.end()) continue;  // the channel has no such rotary axis; the first code that needs the axis reports the fault
    give(n == 0 ? "3204" : "3208", "", static_cast<double>(at - setup.axes.begin() + 1));
    give(n == 0 ? "3205" : "3209", "", letter[0] >= 'A' && letter[0] <= 'C' ? letter[0] - 'A' + 1 : 3);
    give("3212", n == 0 ? "RD1" : "RD2", k.reversed.find(letter) != std::string::npos ? 1 : 0);
  }
  const std::pair<const char*, int> firsts[] = {{"T1", 3213}, {"T2", 3216}, {"E", 3219}, {"D", 3222}};
  for (const auto& [name, first] : firsts)
    if (const auto found = k.vectors.find(name); found != k.vectors.end())
      for (int i = 0; i < 3; ++i) give(std::to_string(first + i), "", found->second[static_cast<std::size_t>(i)]);
}

}  // namespace kadr::setup_reader
