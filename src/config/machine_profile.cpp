// machines/*.toml: what a machine can do. For cli, machine, motion; tested by tests/config/machine_profile_test.cpp.

#include "config/machine_profile.h"

#include <algorithm>
#include <initializer_list>
#include <tuple>

#include "config/embedded.h"
#include "config/nearest.h"
#include "config/read_file.h"
#include "config/told.h"
#include "config/toml_tools.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;
using Done = tl::expected<void, std::string>;
using toml_tools::place;

constexpr std::string_view folder = "machines/";
constexpr std::string_view ending = ".toml";

Done known_keys(const std::string& file, const toml::table& table, std::initializer_list<std::string_view> known) {
  for (const auto& [key, node] : table)
    if (std::find(known.begin(), known.end(), key.str()) == known.end())
      return Failed(place(file, node) +
                    told("unknown key '" + std::string(key.str()) + "'", "неизвестный ключ «" + std::string(key.str()) + "»"));
  return {};
}

/// `planner`, if the key is there.
Done mode_of(const std::string& file, const toml::table& table, PlannerMode& to) {
  const toml::node* const node = table.get("planner");
  if (node == nullptr) return {};
  const auto word = node->value<std::string_view>();
  if (word == "control") to = PlannerMode::control;
  else if (word == "optimal") to = PlannerMode::optimal;
  else
    return Failed(place(file, *node) +
                  told("'planner' must be \"control\" or \"optimal\"", "planner: должно быть \"control\" или \"optimal\""));
  return {};
}

tl::expected<AxisProfile, std::string> axis_of(const std::string& file, const std::string& name, const toml::node& node) {
  const toml::table* const row = node.as_table();
  if (row == nullptr)
    return Failed(place(file, node) + told("axis " + name + " must be a table: { rapid = …, limits = [least, most] }",
                                           "ось " + name + " задаётся таблицей: { rapid = …, limits = [меньшее, большее] }"));
  AxisProfile axis;
  if (auto done = known_keys(file, *row, {"rapid", "limits", "acceleration", "jerk"}); !done) return Failed(done.error());
  const std::tuple<const char*, const NumberRange&, double&> numbers[] = {
      {"rapid", ranges::rate, axis.rapid}, {"acceleration", ranges::acceleration, axis.acceleration}, {"jerk", ranges::jerk, axis.jerk}};
  for (const auto& [key, range, to] : numbers)
    if (auto done = toml_tools::number(file, *row, key, range, to); !done) return Failed(done.error());
  if (auto done = toml_tools::span(file, *row, "limits", ranges::position, axis.least, axis.most); !done) return Failed(done.error());
  return axis;
}

tl::expected<MachineProfile, std::string> profile_of(const std::string& file, const toml::table& table) {
  MachineProfile profile;
  if (auto done = known_keys(file, table, {"id", "name", "tool_change", "spindle_start", "tolerance", "planner", "axes"}); !done)
    return Failed(done.error());
  profile.id = table["id"].value_or(std::string());
  if (profile.id.empty()) return Failed(file + ": " + told("id is missing", "нет ключа id"));
  if (const toml::table* const name = table["name"].as_table()) {
    const Text text = toml_tools::text_of(*name);
    profile.name_en = text.en;
    profile.name_ru = text.ru;
  }
  const std::tuple<const char*, const NumberRange&, double&> numbers[] = {{"tool_change", ranges::seconds, profile.tool_change_s},
                                                                          {"spindle_start", ranges::seconds, profile.spindle_start_s},
                                                                          {"tolerance", ranges::distance, profile.tolerance}};
  for (const auto& [key, range, to] : numbers)
    if (auto done = toml_tools::number(file, table, key, range, to); !done) return Failed(done.error());
  if (auto done = mode_of(file, table, profile.planner); !done) return Failed(done.error());
  const toml::table* const axes = table["axes"].as_table();
  if (axes == nullptr) return Failed(file + ": " + told("[axes] is missing", "нет таблицы [axes]"));
  for (const auto& [name, node] : *axes) {
    auto axis = axis_of(file, std::string(name.str()), node);
    if (!axis) return Failed(axis.error());
    profile.axes.emplace(name.str(), *axis);
  }
  return profile;
}

tl::expected<MachineProfile, std::string> parse(std::string_view text, const std::string& file) {
  const auto table = toml_tools::parsed(text, file);
  return table ? profile_of(file, *table) : Failed(table.error());
}

}  // namespace

tl::expected<MachineProfile, std::string> load_machine(const std::string& name) {
  if (name.ends_with(ending)) {
    const auto text = read_file(name);
    if (!text) return Failed(text.error());
    return parse(*text, name);
  }
  const std::string file = std::string(folder) + in_small_letters(name) + std::string(ending);
  if (const auto text = toml_tools::embedded_text(file)) return parse(*text, file);
  std::string known;
  for (const std::string& id : built_in_machines()) known += (known.empty() ? "" : ", ") + id;
  return Failed(told("no machine '" + name + "'; there are: " + known + ", or a file of your own (NAME.toml)",
                     "станка «" + name + "» нет; есть: " + known + " или свой файл (ИМЯ.toml)") +
                did_you_mean(name, built_in_machines()));
}

std::vector<std::string> built_in_machines() {
  std::vector<std::string> ids;
  for (const EmbeddedFile& file : embedded_files())
    if (file.name.starts_with(folder)) ids.emplace_back(file.name.substr(folder.size(), file.name.size() - folder.size() - ending.size()));
  return ids;
}

}  // namespace kadr
