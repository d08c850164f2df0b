// Reads machines/*.toml, which describe the capabilities of machines. Used by cli, machine, motion; tested by
// tests/config/machine_profile_test.cpp.

#include "config/machine/machine_profile.h"

#include <algorithm>
#include <charconv>
#include <initializer_list>
#include <tuple>

#include "config/embedded.h"
#include "config/machine/machine_bodies_file.h"
#include "config/nearest.h"
#include "config/read_file.h"
#include "config/tools/toml_tools.h"
#include "texts/machine_file.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;
using Done = tl::expected<void, std::string>;
using toml_tools::place;

constexpr std::string_view folder = "machines/";
constexpr std::string_view ending = ".toml";
constexpr NumberRange centre_angle = {10, 150, texts::ranges::degrees};  // of the point of a lathe's centre

Done known_keys(const std::string& file, const toml::table& table, std::initializer_list<std::string_view> known) {
  for (const auto& [key, node] : table)
    if (std::find(known.begin(), known.end(), key.str()) == known.end())
      return Failed(place(file, node) + translated(texts::machine_file::unknown_key, key.str()));
  return {};
}

/// Reads the key `planner`, if the file has it.
Done mode_of(const std::string& file, const toml::table& table, PlannerMode& to) {
  const toml::node* const node = table.get("planner");
  if (node == nullptr) return {};
  const auto word = node->value<std::string_view>();
  if (word == "control") to = PlannerMode::control;
  else if (word == "optimal") to = PlannerMode::optimal;
  else return Failed(place(file, *node) + translated(texts::machine_file::planner_form));
  return {};
}

/// Reads a key whose value is three numbers, if the key is present.
Done vector_of(const std::string& file, const toml::table& row, std::string_view key, Vec3& to) {
  const toml::node* const node = row.get(key);
  if (node == nullptr) return {};
  const toml::array* const list = node->as_array();
  double parts[3] = {};
  bool fits = list != nullptr && list->size() == 3;
  for (std::size_t i = 0; fits && i < 3; ++i) {
    const auto part = list->get(i)->value<double>();
    fits = part && is_within(*part, ranges::position);
    if (fits) parts[i] = *part;
  }
  if (!fits) return Failed(place(file, *node) + translated(texts::machine_file::three_numbers, key, range_in_words(ranges::position)));
  to = {parts[0], parts[1], parts[2]};
  return {};
}

/// Reads a direction, a key whose value is three numbers, if the key is present, and scales the direction to length 1.
Done direction_of(const std::string& file, const toml::table& row, std::string_view key, Vec3& to) {
  if (auto done = vector_of(file, row, key, to); !done) return done;
  const double l = length(to);
  if (row.contains(key) && !(l > 0)) return Failed(place(file, row, key) + translated(texts::machine_file::no_direction, key));
  if (l > 0) to = 1 / l * to;
  return {};
}

Done flag_of(const std::string& file, const toml::table& row, std::string_view key, bool& to) {
  const toml::node* const node = row.get(key);
  if (node == nullptr) return {};
  if (!node->is_boolean()) return Failed(place(file, *node) + translated(texts::machine_file::true_or_false, key));
  to = *node->value<bool>();
  return {};
}

/// Reads the keys of a joint: `along` of a linear axis, `turns` and `through` of a rotary axis, `reversed`, `roll_over`.
Done joint_of(const std::string& file, const std::string& name, const toml::table& row, AxisJoint& joint) {
  constexpr std::string_view letters = "XYZUVWABC";
  const auto letter = name.empty() ? std::string_view::npos : letters.find(name[0]);
  const bool moves = row.contains("along"), turns = row.contains("turns");
  if (moves && turns) return Failed(place(file, row, "along") + translated(texts::machine_file::along_and_turns, name));
  joint.turns = turns || (!moves && letter != std::string_view::npos && letter >= 6);
  if (letter != std::string_view::npos) {
    const auto main = letter % 3;
    joint.direction = {main == 0 ? 1. : 0., main == 1 ? 1. : 0., main == 2 ? 1. : 0.};
  }
  if (auto done = direction_of(file, row, turns ? "turns" : "along", joint.direction); !done) return done;
  for (const char* const key : {"through", "roll_over"})
    if (!joint.turns && row.contains(key)) return Failed(place(file, row, key) + translated(texts::machine_file::only_rotary, key));
  if (auto done = vector_of(file, row, "through", joint.through); !done) return done;
  if (auto done = flag_of(file, row, "reversed", joint.reversed); !done) return done;
  if (auto done = flag_of(file, row, "roll_over", joint.rolls_over); !done) return done;
  if (joint.rolls_over && row.contains("limits"))
    return Failed(place(file, row, "limits") + translated(texts::machine_file::limits_of_rolling_axis));
  return {};
}

/// Reads a list of axis names in order from the bed. `seen`: the names that both chains have contained so far.
Done chain_of(const std::string& file, const toml::table& table, std::string_view key, const MachineProfile& profile,
              std::vector<std::string>& to, std::vector<std::string>& seen) {
  const toml::node* const node = table.get(key);
  if (node == nullptr) return {};
  const toml::array* const list = node->as_array();
  const auto wrong = [&](const std::string& what) { return Failed(place(file, *node) + what); };
  if (list == nullptr) return wrong(translated(texts::machine_file::list_of_axes, key));
  for (const toml::node& item : *list) {
    const std::string name = item.value_or(std::string());
    const auto axis = profile.axes.find(name);
    if (axis == profile.axes.end()) return wrong(translated(texts::machine_file::no_such_axis, name));
    if (!(length(axis->second.joint.direction) > 0)) return wrong(translated(texts::machine_file::along_or_turns, name));
    if (std::find(seen.begin(), seen.end(), name) != seen.end()) return wrong(translated(texts::machine_file::axis_twice, name));
    seen.push_back(name);
    to.push_back(name);
  }
  return {};
}

Done kinematics_of(const std::string& file, const toml::table& table, MachineProfile& profile) {
  const toml::node* const node = table.get("kinematics");
  if (node == nullptr) return {};
  const toml::table* const row = node->as_table();
  if (row == nullptr) return Failed(place(file, *node) + translated(texts::machine_file::kinematics_form));
  if (auto done = known_keys(file, *row, {"tool", "part", "tool_direction"}); !done) return done;
  std::vector<std::string> seen;
  if (auto done = chain_of(file, *row, "tool", profile, profile.chains.tool, seen); !done) return done;
  if (auto done = chain_of(file, *row, "part", profile, profile.chains.part, seen); !done) return done;
  return direction_of(file, *row, "tool_direction", profile.chains.tool_direction);
}

tl::expected<AxisProfile, std::string> axis_of(const std::string& file, const std::string& name, const toml::node& node) {
  const toml::table* const row = node.as_table();
  if (row == nullptr) return Failed(place(file, node) + translated(texts::machine_file::axis_form, name));
  AxisProfile axis;
  if (auto done = known_keys(file, *row, {"rapid", "limits", "acceleration", "jerk", "along", "turns", "through", "reversed", "roll_over"});
      !done)
    return Failed(done.error());
  const std::tuple<const char*, const NumberRange&, double&> numbers[] = {
      {"rapid", ranges::rate, axis.rapid}, {"acceleration", ranges::acceleration, axis.acceleration}, {"jerk", ranges::jerk, axis.jerk}};
  for (const auto& [key, range, to] : numbers)
    if (auto done = toml_tools::number(file, *row, key, range, to); !done) return Failed(done.error());
  if (auto done = toml_tools::span(file, *row, "limits", ranges::position, axis.least, axis.most); !done) return Failed(done.error());
  if (auto done = joint_of(file, name, *row, axis.joint); !done) return Failed(done.error());
  return axis;
}

/// Reads `[m]`, the names of the machine's M codes: `68 = { en = "chuck clamp", ru = "патрон зажать" }`.
Done m_codes_of(const std::string& file, const toml::table& table, MachineProfile& profile) {
  constexpr std::uint32_t most = 9999;
  const toml::node* const node = table.get("m");
  if (node == nullptr) return {};
  const toml::table* const rows = node->as_table();
  if (rows == nullptr) return Failed(place(file, *node) + translated(texts::machine_file::m_form));
  for (const auto& [key, row] : *rows) {
    const std::string_view digits = key.str();
    std::uint32_t number = 0;
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const toml::table* const names = row.as_table();
    if (fault != std::errc() || end != digits.data() + digits.size() || number > most || names == nullptr)
      return Failed(place(file, row) + translated(texts::machine_file::m_form));
    if (auto done = known_keys(file, *names, {"en", "ru"}); !done) return done;
    Text text = toml_tools::text_of(*names);
    if (text.en.empty() && text.ru.empty()) return Failed(place(file, row) + translated(texts::machine_file::m_form));
    if (text.en.empty()) text.en = text.ru;
    if (text.ru.empty()) text.ru = text.en;
    profile.m_codes[number] = std::move(text);
  }
  return {};
}

using Numbers = std::initializer_list<std::tuple<const char*, const NumberRange&, double&>>;

/// Reads a table of numbers, if the file has it. Those that are 0 before must be stated.
Done work_holding_of(const std::string& file, const toml::table& table, const char* key, std::initializer_list<std::string_view> known,
                     Numbers numbers) {
  const toml::node* const node = table.get(key);
  if (node == nullptr) return {};
  const toml::table* const row = node->as_table();
  if (row == nullptr) return Failed(place(file, *node) + translated(texts::machine_file::table_form, key));
  if (auto done = known_keys(file, *row, known); !done) return done;
  for (const auto& [name, range, to] : numbers) {
    if (auto done = toml_tools::number(file, *row, name, range, to); !done) return done;
    if (!(to > 0)) return Failed(place(file, *node) + translated(texts::machine_file::number_missing, key, name));
  }
  return {};
}

Done work_holding_of(const std::string& file, const toml::table& table, MachineProfile& profile) {
  ChuckProfile& chuck = profile.chuck;
  TailstockProfile& tail = profile.tailstock;
  if (auto done = work_holding_of(file, table, "chuck", {"diameter", "length"},
                                  {{"diameter", ranges::distance, chuck.diameter}, {"length", ranges::distance, chuck.length}});
      !done)
    return done;
  return work_holding_of(file, table, "tailstock", {"angle", "centre", "diameter", "length"},
                         {{"angle", centre_angle, tail.angle},
                          {"centre", ranges::distance, tail.centre},
                          {"diameter", ranges::distance, tail.diameter},
                          {"length", ranges::distance, tail.length}});
}

tl::expected<MachineProfile, std::string> profile_of(const std::string& file, const toml::table& table) {
  MachineProfile profile;
  if (auto done = known_keys(file, table,
                             {"id", "name", "tool_change", "spindle_start", "spindle_speed", "tolerance", "planner", "axes", "kinematics",
                              "bodies", "chuck", "tailstock", "m"});
      !done)
    return Failed(done.error());
  profile.id = table["id"].value_or(std::string());
  if (profile.id.empty()) return Failed(file + ": " + translated(texts::machine_file::id_missing));
  if (const toml::table* const name = table["name"].as_table()) {
    const Text text = toml_tools::text_of(*name);
    profile.name_en = text.en;
    profile.name_ru = text.ru;
  } else {
    profile.name_en = translated_in(Lang::en, texts::machine_file::generic_mill);
    profile.name_ru = translated_in(Lang::ru, texts::machine_file::generic_mill);
  }
  const std::tuple<const char*, const NumberRange&, double&> numbers[] = {{"tool_change", ranges::seconds, profile.tool_change_s},
                                                                          {"spindle_start", ranges::seconds, profile.spindle_start_s},
                                                                          {"spindle_speed", ranges::speed, profile.most_rpm},
                                                                          {"tolerance", ranges::distance, profile.tolerance}};
  for (const auto& [key, range, to] : numbers)
    if (auto done = toml_tools::number(file, table, key, range, to); !done) return Failed(done.error());
  if (auto done = mode_of(file, table, profile.planner); !done) return Failed(done.error());
  const toml::table* const axes = table["axes"].as_table();
  if (axes == nullptr) return Failed(file + ": " + translated(texts::machine_file::axes_missing));
  for (const auto& [name, node] : *axes) {
    auto axis = axis_of(file, std::string(name.str()), node);
    if (!axis) return Failed(axis.error());
    profile.axes.emplace(name.str(), *axis);
  }
  if (auto done = kinematics_of(file, table, profile); !done) return Failed(done.error());
  if (auto done = bodies_of(file, table, profile); !done) return Failed(done.error());
  if (auto done = m_codes_of(file, table, profile); !done) return Failed(done.error());
  if (auto done = work_holding_of(file, table, profile); !done) return Failed(done.error());
  return profile;
}

tl::expected<MachineProfile, std::string> parse(std::string_view text, const std::string& file) {
  const auto table = toml_tools::parsed(text, file);
  return table ? profile_of(file, *table) : Failed(table.error());
}

}  // namespace

tl::expected<MachineProfile, std::string> load_machine(const std::string& name, const FileAccess* door) {
  if (name.ends_with(ending)) {
    const auto text = read_file(name, limits::config_file_bytes, door);
    if (!text) return Failed(text.error());
    return parse(*text, name);
  }
  const std::string file = std::string(folder) + in_small_letters(name) + std::string(ending);
  if (const auto text = toml_tools::embedded_text(file)) return parse(*text, file);
  std::string known;
  for (const std::string& id : built_in_machines()) known += (known.empty() ? "" : ", ") + id;
  return Failed(translated(texts::machine_file::no_machine, name, known) + did_you_mean(name, built_in_machines()));
}

std::vector<std::string> built_in_machines() {
  std::vector<std::string> ids;
  for (const EmbeddedFile& file : embedded_files())
    if (file.name.starts_with(folder)) ids.emplace_back(file.name.substr(folder.size(), file.name.size() - folder.size() - ending.size()));
  return ids;
}

}  // namespace kadr
