#include "config/machine_profile.h"

#include <algorithm>
#include <initializer_list>

#include "config/embedded.h"
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
      return Failed(place(file, node) + "unknown key '" + std::string(key.str()) + "'");
  return {};
}

/// A number not below zero, if the key is there.
Done positive(const std::string& file, const toml::table& table, std::string_view key, double& to) {
  const toml::node* const node = table.get(key);
  if (node == nullptr) return {};
  const auto value = node->value<double>();
  if (!value || !(*value >= 0)) return Failed(place(file, *node) + "'" + std::string(key) + "' must be a number, not below zero");
  to = *value;
  return {};
}

/// `planner`, if the key is there.
Done mode_of(const std::string& file, const toml::table& table, PlannerMode& to) {
  const toml::node* const node = table.get("planner");
  if (node == nullptr) return {};
  const auto word = node->value<std::string_view>();
  if (word == "control") to = PlannerMode::control;
  else if (word == "optimal") to = PlannerMode::optimal;
  else return Failed(place(file, *node) + "'planner' must be \"control\" or \"optimal\"");
  return {};
}

tl::expected<AxisProfile, std::string> axis_of(const std::string& file, const std::string& name, const toml::node& node) {
  const toml::table* const row = node.as_table();
  if (row == nullptr) return Failed(place(file, node) + "axis " + name + " must be a table: { rapid = …, limits = [least, most] }");
  AxisProfile axis;
  if (auto done = known_keys(file, *row, {"rapid", "limits", "acceleration", "jerk"}); !done) return Failed(done.error());
  if (auto done = positive(file, *row, "rapid", axis.rapid); !done) return Failed(done.error());
  if (auto done = positive(file, *row, "acceleration", axis.acceleration); !done) return Failed(done.error());
  if (auto done = positive(file, *row, "jerk", axis.jerk); !done) return Failed(done.error());
  if (axis.rapid == 0) return Failed(place(file, node) + "the rapid rate of axis " + name + " must be above zero");
  if (axis.acceleration == 0 || axis.jerk == 0)
    return Failed(place(file, node) + "acceleration and jerk of axis " + name + " must be above zero");
  const toml::node* const limits = row->get("limits");
  if (limits == nullptr) return axis;
  const toml::array* const pair = limits->as_array();
  const auto least = pair != nullptr && pair->size() == 2 ? (*pair)[0].value<double>() : std::nullopt;
  const auto most = pair != nullptr && pair->size() == 2 ? (*pair)[1].value<double>() : std::nullopt;
  if (!least || !most || !(*least <= *most)) return Failed(place(file, *limits) + "limits of axis " + name + " must be [least, most]");
  axis.least = *least;
  axis.most = *most;
  return axis;
}

tl::expected<MachineProfile, std::string> profile_of(const std::string& file, const toml::table& table) {
  MachineProfile profile;
  if (auto done = known_keys(file, table, {"id", "name", "tool_change", "spindle_start", "tolerance", "planner", "axes"}); !done)
    return Failed(done.error());
  profile.id = table["id"].value_or(std::string());
  if (profile.id.empty()) return Failed(file + ": id is missing");
  if (const toml::table* const name = table["name"].as_table()) {
    const Text text = toml_tools::text_of(*name);
    profile.name_en = text.en;
    profile.name_ru = text.ru;
  }
  if (auto done = positive(file, table, "tool_change", profile.tool_change_s); !done) return Failed(done.error());
  if (auto done = positive(file, table, "spindle_start", profile.spindle_start_s); !done) return Failed(done.error());
  if (auto done = positive(file, table, "tolerance", profile.tolerance); !done) return Failed(done.error());
  if (auto done = mode_of(file, table, profile.planner); !done) return Failed(done.error());
  const toml::table* const axes = table["axes"].as_table();
  if (axes == nullptr) return Failed(file + ": [axes] is missing");
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
    const auto text = toml_tools::read_text(name);
    if (!text) return Failed(name + ": cannot be read");
    return parse(*text, name);
  }
  const std::string file = std::string(folder) + name + std::string(ending);
  if (const auto text = toml_tools::embedded_text(file)) return parse(*text, file);
  std::string known;
  for (const EmbeddedFile& built_in : embedded_files())
    if (built_in.name.starts_with(folder))
      known += (known.empty() ? "" : ", ") +
               std::string(built_in.name.substr(folder.size(), built_in.name.size() - folder.size() - ending.size()));
  return Failed("no machine '" + name + "'; there are: " + known + ", or a file of your own (NAME.toml)");
}

}  // namespace kadr
