// config/setup/setup_keys, config/setup/setup_check: the table of keys. Each key is read with its example by the controls that have it and
// by no other control; a mistyped key is refused.

#include "config/setup/setup_keys.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "config/alarm_texts.h"
#include "config/control/control_file.h"
#include "config/setup/setup_file.h"
#include "config/setup/setup_names.h"

namespace kadr::setup_keys_test {
namespace {

using Json = nlohmann::json;

const std::vector<ControlDef>& controls() {
  static const std::vector<ControlDef> all = [] {
    std::vector<ControlDef> defs;
    for (const std::string& id : built_in_controls()) defs.push_back(load_control(id).value());
    return defs;
  }();
  return all;
}

tl::expected<PlacedSetup, std::string> read(const Json& setup, const ControlDef* def) {
  return read_setup({{"", setup.dump()}}, def, Lang::en);
}

/// Returns a name that is allowed in place of the `*` of a path.
std::string sample_name(SetupNames kind, const ControlDef* def) {
  switch (kind) {
    case SetupNames::axis:
    case SetupNames::axis_of_any:
    case SetupNames::axis_or_all:
    case SetupNames::axis_or_plane: return "X";
    case SetupNames::work_offset: return "G54";
    case SetupNames::variable:
      if (def != nullptr && def->grammar.named_blocks) return "#R2";
      if (def != nullptr && def->grammar.klartext_blocks) return "#Q2";
      return def != nullptr && def->grammar.variables == 0 && !def->grammar.custom_macros ? "R2" : "#100";
    case SetupNames::parameter: return "N1501";
    case SetupNames::place: return "10/1";
    case SetupNames::signal: return "CP_NOWT";
    case SetupNames::shift: return "G92";
    case SetupNames::channel: return "2";
    default: return "1";
  }
}

std::string parent_of(std::string_view path) {
  const std::size_t point = path.rfind('.');
  return point == std::string_view::npos ? "" : std::string(path.substr(0, point));
}

/// Returns a set-up that contains the row's example at its path, inside the example of its top-level key.
Json setup_with(const SetupKey& row, const ControlDef* def) {
  const std::string top(row.path.substr(0, row.path.find('.')));
  Json setup = {{top, Json::parse(setup_key(top)->example)}};
  std::vector<std::string> parts;
  for (std::string path(row.path); !path.empty(); path = parent_of(path)) {
    const std::string name = path.substr(parent_of(path).empty() ? 0 : parent_of(path).size() + 1);
    parts.insert(parts.begin(), name == "*" ? sample_name(setup_key(parent_of(path))->names, def) : name);
  }
  Json* at = &setup;
  for (const std::string& part : parts) {
    if (at->is_array()) at = &at->at(0);
    if (at->is_null()) *at = Json::object();
    at = &(*at)[part];
  }
  *at = Json::parse(row.example);
  if (row.path.starts_with("events.when.")) {  // one of {block, at}, {code, count}, {action}, {program}
    Json when = {{parts.back(), *at}};
    if (parts.back() == "at") when["block"] = "N30";
    if (parts.back() == "count") when["code"] = "M90";
    setup["events"][0]["when"] = when;
  }
  // The example of a table must use names of this control.
  if (def != nullptr && top == "parameters" && !def->parameters.empty()) {
    const ParameterRow& parameter = def->parameters.front();
    setup = {{top, {{(parameter.number >= 0 ? "N" : "") + parameter.name, parameter.initial}}}};
  }
  if (def != nullptr && top == "variables") setup = {{top, {{sample_name(SetupNames::variable, def), 2}}}};
  return setup;
}

TEST(setup_keys, each_is_read_with_its_example) {
  for (const SetupKey& row : setup_keys()) {
    const auto setup = read(setup_with(row, nullptr), nullptr);
    EXPECT_TRUE(setup) << row.path << ": " << setup.error();
    EXPECT_STRNE(plain_text(row.about, Lang::en), "") << row.path;
    EXPECT_STRNE(plain_text(row.about, Lang::ru), "") << row.path;
  }
}

TEST(setup_keys, each_is_read_where_the_control_has_it_and_nowhere_else) {
  for (const ControlDef& def : controls())
    for (const SetupKey& row : setup_keys()) {
      const Json setup = setup_with(row, &def);
      const auto done = read(setup, &def);
      EXPECT_EQ(done.has_value(), has(def, row.needs)) << def.id << " " << setup << " " << (done ? "" : done.error());
    }
}

TEST(setup_keys, parameters_are_shown_by_names_of_the_control) {
  for (const ControlDef& def : controls()) {
    const SetupNamesOf names(&def, def.axes, def.axes);
    const std::vector<std::string> forms = names.forms_of_parameters();
    EXPECT_EQ(forms.empty(), def.parameters.empty()) << def.id;
    for (const std::string& name : forms) {
      EXPECT_TRUE(names.allows(SetupNames::parameter, name)) << def.id << " " << name;
      EXPECT_FALSE(names.parameter_fault(name, 1, false, Lang::en)) << def.id << " " << name;
    }
  }
}

/// What each built-in control has according to its manual: work offsets by code, work offsets by number, correctors, variables, …
TEST(setup_keys, what_the_controls_have) {
  using H = SetupNeeds;
  const std::map<std::string, std::set<H>> expected = {
      {"s2c42", {H::nothing, H::zeros, H::variables, H::parameters}},
      {"mach3", {H::nothing, H::work_offsets, H::variables, H::parameters, H::probe}},
      {"linuxcnc", {H::nothing, H::work_offsets, H::variables, H::turning_lengths, H::ini, H::probe, H::turning}},
      {"grbl", {H::nothing, H::work_offsets, H::parameters, H::probe}},
      {"fanuc",
       {H::nothing, H::work_offsets, H::variables, H::parameters, H::corner_radius, H::turning_lengths, H::tool_management, H::clock,
        H::probe, H::diameters, H::turning, H::machine_axes, H::kinematics}},
      {"fanuc-t",  // turning_lengths: its tables have variables for X and Y
       {H::nothing, H::work_offsets, H::variables, H::parameters, H::corner_radius, H::turning_lengths, H::lathe_offsets,
        H::tool_management, H::clock, H::probe, H::diameters, H::turning, H::machine_axes, H::kinematics}},
      {"haas-st",
       {H::nothing, H::work_offsets, H::variables, H::parameters, H::corner_radius, H::turning_lengths, H::lathe_offsets,
        H::tool_management, H::clock, H::probe, H::diameters, H::turning, H::machine_axes, H::kinematics}},
      {"haas",
       {H::nothing, H::work_offsets, H::variables, H::parameters, H::corner_radius, H::turning_lengths, H::tool_management, H::clock,
        H::probe, H::diameters, H::turning, H::machine_axes, H::kinematics}},
      {"gost", {H::nothing, H::work_offsets, H::diameters, H::turning, H::skip_question}},
      {"correctors", {H::nothing, H::correctors}},
      {"sinumerik", {H::nothing, H::work_offsets, H::variables, H::probe, H::kinematics}},
      {"heidenhain", {H::nothing, H::work_offsets, H::variables, H::probe, H::kinematics}},
      {"nct",
       {H::nothing, H::work_offsets, H::variables, H::parameters, H::corner_radius, H::turning_lengths, H::tool_management, H::clock,
        H::probe, H::diameters, H::turning, H::machine_axes, H::kinematics}},
  };
  for (const ControlDef& def : controls()) {
    std::set<H> there;
    for (int needs = 0; needs <= static_cast<int>(H::kinematics); ++needs)
      if (has(def, static_cast<H>(needs))) there.insert(static_cast<H>(needs));
    std::vector<std::string> ids{def.id};  // a control without a row of its own has what its nearest base has
    ids.insert(ids.end(), def.lineage.begin(), def.lineage.end());
    const auto known = std::find_if(ids.begin(), ids.end(), [&](const std::string& id) { return expected.contains(id); });
    ASSERT_NE(known, ids.end()) << def.id;
    EXPECT_EQ(there, expected.at(*known)) << def.id;
  }
}

/// A number outside its range is refused; the ends of the range are accepted.
TEST(setup_keys, ranges) {
  for (const SetupKey& row : setup_keys()) {
    if (row.form != SetupForm::number && row.form != SetupForm::whole) continue;
    const auto with = [&](double value) {
      SetupKey changed = row;
      const std::string text = Json(value).dump();
      changed.example = text;
      return read(setup_with(changed, nullptr), nullptr).has_value();
    };
    if (row.range.least > -1e299) {
      EXPECT_TRUE(with(row.range.least)) << row.path;
      EXPECT_FALSE(with(row.range.least - 1)) << row.path;
    }
    if (row.range.most < 1e299) {
      EXPECT_TRUE(with(row.range.most)) << row.path;
      EXPECT_FALSE(with(row.range.most + 1)) << row.path;
    }
  }
}

/// Appends the path from the root of every key of the set-up, at any depth, to `to`.
void key_paths(const Json& value, std::vector<std::string> key_path, std::vector<std::vector<std::string>>& to) {
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      key_path.push_back(std::to_string(i));
      key_paths(value[i], key_path, to);
      key_path.pop_back();
    }
  }
  if (!value.is_object()) return;
  for (const auto& [key, item] : value.items()) {
    key_path.push_back(key);
    to.push_back(key_path);
    key_paths(item, key_path, to);
    key_path.pop_back();
  }
}

Json renamed(const Json& setup, const std::vector<std::string>& key_path, const std::string& name) {
  Json changed = setup;
  Json* at = &changed;
  for (std::size_t i = 0; i + 1 < key_path.size(); ++i) at = at->is_array() ? &(*at)[std::stoul(key_path[i])] : &(*at)[key_path[i]];
  const Json value = (*at)[key_path.back()];
  at->erase(key_path.back());
  (*at)[name] = value;
  return changed;
}

/// Returns true if `name` is another key, row or name that the control has at this path.
bool is_known_there(const std::vector<std::string>& key_path, const std::string& name, const ControlDef& def) {
  std::string path;
  for (std::size_t i = 0; i + 1 < key_path.size(); ++i) {
    const SetupKey* const row = path.empty() ? nullptr : setup_key(path);
    if (row != nullptr && row->form == SetupForm::tables) continue;  // an index such as "0"
    const bool is_name = row != nullptr && row->names != SetupNames::fixed;
    path += (path.empty() ? "" : ".") + (is_name ? "*" : key_path[i]);
  }
  const SetupKey* const parent = path.empty() ? nullptr : setup_key(path);
  if (parent == nullptr || parent->names == SetupNames::fixed || parent->form == SetupForm::tables) {
    const SetupKey* const row = name == "*" ? nullptr : setup_key(path.empty() ? name : path + "." + name);
    return row != nullptr && has(def, row->needs);
  }
  return SetupNamesOf(&def, def.axes, def.axes).allows(parent->names, name);
}

/// Changes, removes or appends one letter of each key. The result must be refused or be another existing key.
TEST(setup_keys, a_mistyped_key_never_passes) {
  std::size_t tried = 0;
  for (const ControlDef& def : controls())
    for (const SetupKey& row : setup_keys()) {
      if (!has(def, row.needs) || row.path == "files" || row.path == "frame") continue;
      const Json good = setup_with(row, &def);
      std::vector<std::vector<std::string>> key_paths_found;
      key_paths(good, {}, key_paths_found);
      for (const auto& key_path : key_paths_found)
        for (std::size_t i = 0; i <= key_path.back().size(); ++i)
          for (const char letter : {'x', 'Q', '7', '\0'}) {
            std::string name = key_path.back();
            if (letter == '\0' && i < name.size()) name.erase(i, 1);
            else if (i < name.size()) name[i] = letter;
            else name += letter == '\0' ? ' ' : letter;
            if (name == key_path.back()) continue;
            const auto done = read(renamed(good, key_path, name), &def);
            ++tried;
            if (done) EXPECT_TRUE(is_known_there(key_path, name, def)) << def.id << ": " << renamed(good, key_path, name);
            else EXPECT_NE(done.error().find("setup key '"), std::string::npos) << done.error();
          }
    }
  EXPECT_GT(tried, 10'000U);
}

TEST(setup_keys, no_name_where_a_key_is_a_star) {
  EXPECT_FALSE(read({{"offsets", {{"*", Json::object()}}}}, nullptr));
  EXPECT_FALSE(read({{"*", Json::object()}}, nullptr));
}

TEST(setup_keys, a_key_given_twice) {
  const auto twice = read_setup({{"s.json", "{\"feed\": 1,\n \"feed\": 2}"}}, nullptr, Lang::en);
  ASSERT_FALSE(twice);
  EXPECT_TRUE(twice.error().starts_with("s.json:2:")) << twice.error();
}

TEST(setup_keys, one_laid_over_the_other) {
  const auto both = read_setup({{"s.json", R"({"offsets": {"1": {"length": 5, "radius": 2}}, "correctors": {"3": null}})"},
                                {"--tool 1:r8", R"({"offsets": {"1": {"radius": 8}}})"}},
                               nullptr, Lang::en);
  ASSERT_TRUE(both) << both.error();
  EXPECT_EQ(both->setup.offsets.at(1).length, 5);
  EXPECT_EQ(both->setup.offsets.at(1).radius, 8);
  EXPECT_EQ(both->stated, (std::set<std::string>{"offsets.1", "offsets.1.length", "offsets.1.radius"}));
}

/// null is a value of its own: an acceleration without limit, a vacant variable, a probe that touches nothing.
TEST(setup_keys, null_is_kept) {
  const auto setup =
      read({{"machine", {{"*", {{"acceleration", nullptr}}}}}, {"variables", {{"#1", nullptr}}}, {"probe", {{"2", nullptr}}}}, nullptr);
  ASSERT_TRUE(setup);
  EXPECT_TRUE(setup->setup.machine.at("*").no_acceleration);
  EXPECT_TRUE(setup->setup.variables.contains("#1"));
  EXPECT_TRUE(setup->setup.probe.contains(2));
}

}  // namespace
}  // namespace kadr::setup_keys_test
