// Reads [[bodies]] of machines/*.toml. Used by config/machine/machine_profile; tested by tests/config/machine_bodies_test.cpp.

#include "config/machine/machine_bodies_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "config/nearest.h"
#include "config/range.h"
#include "config/tools/toml_tools.h"
#include "texts/machine_bodies.h"
#include "texts/machine_file.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;
using Done = tl::expected<void, std::string>;
using toml_tools::place;

constexpr std::size_t max_bodies = 256;
constexpr std::size_t longest_name = 100;  // greatest length of a body's name, bytes
constexpr std::string_view body_keys[] = {"name", "on", "box", "cylinder", "file"};
constexpr std::string_view body_forms[] = {"box", "cylinder", "file"};

/// Returns a list of exactly `count` numbers; nullopt if the node is not a list of this form.
std::optional<std::vector<double>> numbers_of_list(const toml::node& node, std::size_t count) {
  const toml::array* const list = node.as_array();
  if (list == nullptr || list->size() != count) return std::nullopt;
  std::vector<double> numbers;
  for (const toml::node& item : *list) {
    const auto number = item.value<double>();
    if (!number || !is_within(*number, ranges::position)) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

Done box_of_body(const std::string& file, const toml::node& node, BodyShape& shape) {
  const auto n = numbers_of_list(node, 6);
  if (!n || !((*n)[0] < (*n)[3] && (*n)[1] < (*n)[4] && (*n)[2] < (*n)[5]))
    return Failed(place(file, node) + translated(texts::machine_bodies::box_form, range_in_words(ranges::position)));
  shape.form = BodyShape::Form::box;
  shape.least = {(*n)[0], (*n)[1], (*n)[2]};
  shape.most = {(*n)[3], (*n)[4], (*n)[5]};
  return {};
}

Done cylinder_of_body(const std::string& file, const toml::node& node, BodyShape& shape) {
  const auto n = numbers_of_list(node, 5);
  if (!n || !((*n)[2] < (*n)[3] && (*n)[4] > 0))
    return Failed(place(file, node) + translated(texts::machine_bodies::cylinder_form, range_in_words(ranges::position)));
  shape.form = BodyShape::Form::cylinder;
  shape.centre = {(*n)[0], (*n)[1]};
  shape.bottom = (*n)[2], shape.top = (*n)[3], shape.diameter = (*n)[4];
  return {};
}

/// Reads the path of a body's mesh file. The path is relative to the folder of the machine's file.
Done file_of_body(const std::string& file, const toml::node& node, BodyShape& shape) {
  const std::string name = node.value_or(std::string());
  const std::string small = in_small_letters(name);
  if (!small.ends_with(".stl") && !small.ends_with(".3mf")) return Failed(place(file, node) + translated(texts::machine_bodies::file_form));
  shape.form = BodyShape::Form::file;
  const std::filesystem::path path(name);
  shape.file = path.is_absolute() ? name : (std::filesystem::path(file).parent_path() / path).string();
  return {};
}

Done shape_of_body(const std::string& file, const toml::table& row, BodyShape& shape) {
  const auto forms = std::count_if(std::begin(body_forms), std::end(body_forms), [&](std::string_view key) { return row.contains(key); });
  if (forms != 1) return Failed(place(file, row) + translated(texts::machine_bodies::one_form));
  if (const toml::node* const box = row.get("box")) return box_of_body(file, *box, shape);
  if (const toml::node* const cylinder = row.get("cylinder")) return cylinder_of_body(file, *cylinder, shape);
  return file_of_body(file, *row.get("file"), shape);
}

/// Returns the axes that may carry a body: those of [kinematics]; without this section, X, Y, Z, which then carry the tool.
std::vector<std::string> carriers_of(const MachineProfile& profile) {
  if (!profile.chains.given()) return {"X", "Y", "Z"};
  std::vector<std::string> all = profile.chains.tool;
  all.insert(all.end(), profile.chains.part.begin(), profile.chains.part.end());
  return all;
}

Done carrier_of(const std::string& file, const toml::table& row, const MachineProfile& profile, std::string& on) {
  const std::string word = row["on"].value_or(std::string());
  if (word == "bed") return {};
  const std::vector<std::string> known = carriers_of(profile);
  on = word;
  if (std::find(known.begin(), known.end(), word) != known.end()) return {};
  return Failed(place(file, row, "on") + translated(texts::machine_bodies::carrier_form, fmt::format("{}", fmt::join(known, ", "))));
}

tl::expected<MachineBody, std::string> body_of_row(const std::string& file, const toml::node& node, const MachineProfile& profile) {
  const toml::table* const row = node.as_table();
  if (row == nullptr) return Failed(place(file, node) + translated(texts::machine_bodies::body_form));
  for (const auto& [key, value] : *row)
    if (std::find(std::begin(body_keys), std::end(body_keys), key.str()) == std::end(body_keys))
      return Failed(place(file, value) + translated(texts::machine_file::unknown_key, key.str()));
  MachineBody body;
  body.name = (*row)["name"].value_or(std::string());
  if (body.name.empty() || body.name.size() > longest_name)
    return Failed(place(file, *row, "name") + translated(texts::machine_bodies::name_form));
  if (auto done = carrier_of(file, *row, profile, body.on); !done) return Failed(done.error());
  if (auto done = shape_of_body(file, *row, body.shape); !done) return Failed(done.error());
  return body;
}

}  // namespace

tl::expected<void, std::string> bodies_of(const std::string& file, const toml::table& table, MachineProfile& profile) {
  const toml::node* const node = table.get("bodies");
  if (node == nullptr) return {};
  const toml::array* const list = node->as_array();
  if (list == nullptr) return Failed(place(file, *node) + translated(texts::machine_bodies::bodies_form));
  if (list->size() > max_bodies) return Failed(place(file, *node) + translated(texts::machine_bodies::too_many));
  for (const toml::node& item : *list) {
    auto body = body_of_row(file, item, profile);
    if (!body) return Failed(body.error());
    profile.bodies.push_back(std::move(*body));
  }
  return {};
}

}  // namespace kadr
