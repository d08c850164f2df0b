#include "config/setup.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

namespace kadr {
namespace {

using Json = nlohmann::json;

/// Inside this file a wrong key or form leaves by this; parse_setup turns it into its error sentence.
struct Wrong {
  std::string sentence;
};

[[noreturn]] void wrong(const std::string& key, const std::string& form) { throw Wrong{"setup key '" + key + "' must be " + form}; }
[[noreturn]] void not_served(const std::string& key) { throw Wrong{"setup key '" + key + "' is not served by this control yet"}; }

/// Number of single-character edits that turn one word into the other.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

template <class Rows>
[[noreturn]] void unknown(const std::string& key, const std::string& inside, const Rows& known) {
  std::string nearest;
  for (const auto& row : known)
    if (nearest.empty() || edits(key, row) < edits(key, nearest)) nearest = row;
  throw Wrong{"unknown setup key '" + (inside.empty() ? "" : inside + ".") + key + "'; the nearest known one is '" + nearest + "'"};
}

double number(const Json& value, const std::string& key) {
  if (!value.is_number() || !std::isfinite(value.get<double>())) wrong(key, "a number");
  return value.get<double>();
}

int whole(const Json& value, const std::string& key) {
  const double n = number(value, key);
  if (n != std::floor(n) || std::abs(n) > 1e9) wrong(key, "a whole number");
  return static_cast<int>(n);
}

bool flag(const Json& value, const std::string& key) {
  if (!value.is_boolean()) wrong(key, "true or false");
  return value.get<bool>();
}

std::string word(const Json& value, const std::string& key) {
  if (!value.is_string()) wrong(key, "a text");
  return value.get<std::string>();
}

/// "3" as the name of a row.
int row_number(const std::string& name, const std::string& key) {
  if (name.empty() || name.size() > 9 || name.find_first_not_of("0123456789") != std::string::npos)
    wrong(key + "." + name, "named by a whole number");
  return std::stoi(name);
}

const Json& table(const Json& value, const std::string& key) {
  if (!value.is_object()) wrong(key, "a table { … }");
  return value;
}

template <class T>
std::vector<T> list(const Json& value, const std::string& key, T (*read)(const Json&, const std::string&)) {
  if (!value.is_array()) wrong(key, "a list [ … ]");
  std::vector<T> items;
  for (const Json& item : value) items.push_back(read(item, key));
  return items;
}

AxisValues axis_values(const Json& value, const std::string& key) {
  constexpr double farthest = 1e7;  // mm: ten kilometres, as for a program's own positions
  AxisValues axes;
  for (const auto& [axis, position] : table(value, key).items()) {
    axes[axis] = number(position, key + "." + axis);
    if (std::abs(axes[axis]) > farthest) wrong(key + "." + axis, "at most ten million");
  }
  return axes;
}

template <class T>
void numbered(const Json& value, const std::string& key, std::map<int, T>& to, T (*read)(const Json&, const std::string&)) {
  for (const auto& [name, row] : table(value, key).items()) to[row_number(name, key)] = read(row, key + "." + name);
}

/// null, false, 0, "" and what holds nothing else: says what is so anyway.
bool neutral(const Json& value) {
  if (value.is_null() || (value.is_boolean() && !value.get<bool>()) || (value.is_number() && value.get<double>() == 0)) return true;
  if (value.is_string()) return value.get_ref<const std::string&>().empty();
  return value.is_structured() && std::all_of(value.begin(), value.end(), neutral);
}

using Reader = std::function<void(const Json&, const std::string&)>;
using Readers = std::map<std::string, Reader>;

/// Hands each key of a table to its reader.
void read_table(const Json& value, const std::string& inside, const Readers& readers) {
  for (const auto& [key, item] : table(value, inside.empty() ? "setup" : inside).items()) {
    const auto found = readers.find(key);
    if (found == readers.end()) {
      std::vector<std::string> known;
      for (const auto& [name, reader] : readers) known.push_back(name);
      unknown(key, inside, known);
    }
    found->second(item, inside.empty() ? key : inside + "." + key);
  }
}

void only_neutral(const Json& value, const std::string& key) {
  if (!neutral(value)) not_served(key);
}

void only_first(const Json& value, const std::string& key) {
  if (!value.is_null() && value != 1) not_served(key);
}

Reader to_number(double& to) {
  return [&to](const Json& value, const std::string& key) { to = number(value, key); };
}

ToolOffset tool_offset(const Json& value, const std::string& key) {
  ToolOffset offset;
  read_table(value, key,
             {{"length", to_number(offset.length)},
              {"length_wear", to_number(offset.length_wear)},
              {"radius", to_number(offset.radius)},
              {"radius_wear", to_number(offset.radius_wear)},
              {"corner_radius", only_neutral},
              {"corner_radius_wear", only_neutral}});
  return offset;
}

/// Axes of a work offset; a basic rotation in a plane must be 0.
AxisValues work_offset(const Json& value, const std::string& key) {
  AxisValues axes = axis_values(value, key);
  for (const char* plane : {"G17", "G18", "G19"})
    if (const auto found = axes.find(plane); found != axes.end()) {
      if (found->second != 0) not_served(key + "." + plane);
      axes.erase(found);
    }
  return axes;
}

AxisLimits axis_limits(const Json& value, const std::string& key) {
  AxisLimits axis;
  const Reader rapid = [&](const Json& item, const std::string& name) {
    if (item.is_null()) return;
    axis.rapid = number(item, name);
    if (!(*axis.rapid > 0)) wrong(name, "above zero");
  };
  const Reader limits = [&](const Json& item, const std::string& name) {
    if (item.is_null()) return;
    if (!item.is_array() || item.size() != 2) wrong(name, "[least, most]");
    axis.limits = {number(item[0], name), number(item[1], name)};
    if (axis.limits->first > axis.limits->second) wrong(name, "[least, most]");
  };
  read_table(value, key,
             {{"rapid", rapid},
              {"limits", limits},
              {"acceleration", only_neutral},
              {"jerk_time", only_neutral},
              {"zone3", only_neutral},
              {"position_error", only_neutral}});
  return axis;
}

void spindle(const Json& value, const std::string& key, Setup& setup) {
  const Reader dir = [&](const Json& item, const std::string& name) {
    std::string& direction = setup.spindles[1].dir;
    direction = word(item, name);
    if (direction != "cw" && direction != "ccw" && direction != "stop") wrong(name, "\"cw\", \"ccw\" or \"stop\"");
  };
  for (const auto& [name, row] : table(value, key).items()) {
    if (row_number(name, key) != 1) not_served(key + "." + name);
    SpindleSetup& spindle = setup.spindles[1];
    read_table(row, key + "." + name,
               {{"rpm", to_number(spindle.rpm)},
                {"dir", dir},
                {"name", only_neutral},
                {"channel", only_first},
                {"angle", only_neutral},
                {"ranges", only_neutral}});
  }
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
  if (neutral(value)) return;
  ProbeHole probed;
  bool has_hole = false;
  read_table(value, key, {{"tip_radius", to_number(probed.tip_radius)}, {"hole", [&](const Json& item, const std::string& name) {
                                                                           hole(item, name, probed);
                                                                           has_hole = true;
                                                                         }}});
  if (!has_hole) wrong(key, "a table with 'hole'");
  if (!(probed.tip_radius >= 0)) wrong(key + ".tip_radius", "zero or above");
  setup.probe_hole = probed;
}

/// "#100", "R2".
bool names_variable(const std::string& name) {
  if (name.size() < 2 || name.size() > 8 || name.find_first_not_of("0123456789", 1) != std::string::npos) return false;
  return name[0] == '#' || (name[0] == 'R' && name.size() == 2);
}

std::optional<double> number_or_vacant(const Json& value, const std::string& key) {
  return value.is_null() ? std::nullopt : std::optional(number(value, key));
}

std::optional<AxisValues> signal_position(const Json& value, const std::string& key) {
  return value.is_null() ? std::nullopt : std::optional(axis_values(value, key));
}

void parts_of_motion(const Json& value, const std::string& key, Setup& setup) {
  setup.points = list(value, key, number);
  for (const double part : setup.points)
    if (!(part >= 0 && part <= 1)) wrong(key, "a list of parts, 0 to 1");
}

/// What a run starts with.
Readers readers_of_state(Setup& s) {
  return {
      {"axes", [&](const Json& v, const std::string& k) { s.axes = list(v, k, word); }},
      {"start", [&](const Json& v, const std::string& k) { s.start = axis_values(v, k); }},
      {"start_frame",
       [&](const Json& v, const std::string& k) {
         if (v != "work" && v != "machine") wrong(k, "\"work\" or \"machine\"");
         s.start_in_work = v == "work";
       }},
      {"modal", [&](const Json& v, const std::string& k) { s.modal = list(v, k, word); }},
      {"feed", [&](const Json& v, const std::string& k) { s.feed = number_or_vacant(v, k); }},
      {"offsets", [&](const Json& v, const std::string& k) { numbered(v, k, s.offsets, tool_offset); }},
      {"work_offsets",
       [&](const Json& v, const std::string& k) {
         for (const auto& [name, axes] : table(v, k).items()) s.work_offsets[name] = work_offset(axes, k + "." + name);
       }},
      {"zeros", [&](const Json& v, const std::string& k) { numbered(v, k, s.zeros, axis_values); }},
      {"correctors", [&](const Json& v, const std::string& k) { numbered(v, k, s.correctors, number); }},
      {"variables",
       [&](const Json& v, const std::string& k) {
         for (const auto& [name, value] : table(v, k).items()) {
           if (!names_variable(name)) wrong(k + "." + name, "named #n or R0 to R9");
           s.variables[name] = number_or_vacant(value, k + "." + name);
         }
       }},
      {"spindle", [&](const Json& v, const std::string& k) { spindle(v, k, s); }},
      {"tool", [&](const Json& v, const std::string& k) { s.tool = whole(v, k); }},
      {"points", [&](const Json& v, const std::string& k) { parts_of_motion(v, k, s); }},
      {"watch", [&](const Json& v, const std::string& k) { s.watch = list(v, k, word); }},
  };
}

/// The machine and its operator.
Readers readers_of_machine(Setup& s) {
  const Reader override_part = [&](const Json& v, const std::string& k) {
    read_table(v, k,
               {{"feed", to_number(s.feed_override)}, {"rapid", to_number(s.rapid_override)}, {"spindle", to_number(s.spindle_override)}});
    if (std::min({s.feed_override, s.rapid_override, s.spindle_override}) < 0) wrong(k, "zero or above");
  };
  return {
      {"machine",
       [&](const Json& v, const std::string& k) {
         for (const auto& [axis, row] : table(v, k).items()) s.machine[axis] = axis_limits(row, k + "." + axis);
       }},
      {"skip", [&](const Json& v, const std::string& k) { s.skip = list(v, k, whole); }},
      {"optional_stop", [&](const Json& v, const std::string& k) { s.optional_stop = flag(v, k); }},
      {"mirror", [&](const Json& v, const std::string& k) { s.mirror = list(v, k, word); }},
      {"override", override_part},
      {"reference_points", [&](const Json& v, const std::string& k) { numbered(v, k, s.reference_points, axis_values); }},
      {"probe", [&](const Json& v, const std::string& k) { numbered(v, k, s.probe, signal_position); }},
      {"probe_workpiece", [&](const Json& v, const std::string& k) { probe_workpiece(v, k, s); }},
  };
}

/// Every key of tests/golden/README.md.
Readers readers_of(Setup& setup) {
  Readers readers = readers_of_state(setup);
  readers.merge(readers_of_machine(setup));
  for (const char* key : {"single_block", "clock", "tool_table", "place_table", "signals", "search", "kinematics", "channels", "events",
                          "parameters", "plane", "diameter", "files", "main_file"})
    readers.emplace(key, only_neutral);
  readers.emplace("channel", only_first);
  return readers;
}

}  // namespace

const SpindleSetup& Setup::spindle() const {
  static const SpindleSetup stands;
  const auto found = spindles.find(1);
  return found == spindles.end() ? stands : found->second;
}

tl::expected<Setup, std::string> parse_setup(std::string_view json) {
  Setup setup;
  try {
    read_table(Json::parse(json), "", readers_of(setup));
  } catch (const Wrong& error) {
    return tl::unexpected(error.sentence);
  } catch (const Json::exception& error) {
    return tl::unexpected("the setup is not JSON: " + std::string(error.what()));
  }
  return setup;
}

tl::expected<Setup, std::string> load_setup(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return tl::unexpected(file + ": cannot be read");
  std::ostringstream text;
  text << stream.rdbuf();
  auto setup = parse_setup(std::move(text).str());
  return setup ? setup : tl::unexpected(file + ": " + setup.error());
}

}  // namespace kadr
