// Reads the section [guess] of control files, and of the program languages in controls/dialects.toml. Used by config/control/guess and
// config/control/control_loader_words; tested by tests/config/guess_test.cpp.

#include "config/control/guess_rows.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "config/control/control_file.h"
#include "config/tools/toml_tools.h"
#include "texts/control_file.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;

tl::expected<double, std::string> weight_of(const toml::node& node, std::string_view key, const std::string& file) {
  constexpr double most = 20;
  const auto weight = node.value<double>();
  if (weight && !node.is_boolean() && *weight != 0 && std::abs(*weight) <= most) return *weight;
  return Failed(toml_tools::place(file, node) + translated(texts::control_file::bad_weight, key, most));
}

/// Reads the marks of one table, but not of the tables inside it.
std::optional<std::string> take_marks(const toml::table& table, MarkLocation place, const std::string& file, GuessRows& rows) {
  for (const auto& [key, node] : table) {
    if (node.is_table() && place == MarkLocation::statement) continue;
    const auto weight = weight_of(node, key.str(), file);
    if (!weight) return weight.error();
    const LineSigns needs = signs_needed(key.str());
    rows.marks.push_back({std::string(key.str()), *weight, place, needs, rarest_sign(needs)});
  }
  return std::nullopt;
}

std::optional<std::string> take_traits(const toml::table& table, const std::string& file, GuessRows& rows) {
  std::vector<std::string_view> keys;
  for (std::size_t i = 0; i < static_cast<std::size_t>(TextTrait::count); ++i) keys.push_back(text_of(static_cast<TextTrait>(i)).key);
  for (const auto& [key, node] : table) {
    const auto known = std::find(keys.begin(), keys.end(), key.str());
    if (known == keys.end()) {
      const std::string_view near = toml_tools::nearest(key.str(), keys);
      return toml_tools::place(file, node) + translated(texts::control_file::unknown_key, key.str()) +
             (near.empty() ? "" : translated(texts::control_file::nearest, near));
    }
    const auto weight = weight_of(node, key.str(), file);
    if (!weight) return weight.error();
    rows.traits.emplace_back(static_cast<TextTrait>(known - keys.begin()), *weight);
  }
  return std::nullopt;
}

}  // namespace

tl::expected<GuessRows, std::string> guess_rows_of(const toml::table& guess, const std::string& file) {
  GuessRows rows;
  auto wrong = take_marks(guess, MarkLocation::statement, file, rows);
  for (const auto& [key, node] : guess) {
    const toml::table* const part = node.as_table();
    if (part == nullptr || wrong) continue;
    if (key.str() == "text") wrong = take_traits(*part, file, rows);
    else if (key.str() == "comment") wrong = take_marks(*part, MarkLocation::comment, file, rows);
    else if (key.str() == "name") wrong = take_marks(*part, MarkLocation::name, file, rows);
    else wrong = weight_of(node, key.str(), file).error();
  }
  if (wrong) return Failed(*wrong);
  return rows;
}

const std::vector<GuessRows>& built_in_guess_rows() {
  static const std::vector<GuessRows> all = [] {
    std::vector<GuessRows> of;
    for (const std::string& id : built_in_controls()) {
      const std::string file = "controls/" + id + ".toml";
      const auto table = toml_tools::embedded_table(file);
      const toml::table* const guess = table ? (*table)["guess"].as_table() : nullptr;
      if (guess == nullptr) continue;
      auto rows = guess_rows_of(*guess, file);
      // The [guess] section of a built-in control is always valid, because tests/controls_table.py loads every built-in file
      assert(rows);
      rows->control = id;
      of.push_back(std::move(*rows));
    }
    return of;
  }();
  return all;
}

const std::vector<GuessRows>& dialect_rows() {
  static const std::vector<GuessRows> all = [] {
    constexpr const char* file = "controls/dialects.toml";
    std::vector<GuessRows> of;
    const auto table = toml_tools::embedded_table(file);
    assert(table);
    for (const auto& [id, node] : *table) {
      const toml::table& dialect = *node.as_table();
      auto rows = guess_rows_of(*dialect["guess"].as_table(), file);
      assert(rows);  // the rows of a program language are always valid, because tests/config/guess_test.cpp reads all of them
      rows->control = std::string(id.str());
      rows->name_en = dialect["name"]["en"].value_or(std::string());
      rows->name_ru = dialect["name"]["ru"].value_or(std::string());
      if (const toml::array* const by = dialect["refused_by"].as_array())
        for (const toml::node& control : *by) rows->refused_by.push_back(control.value_or(std::string()));
      of.push_back(std::move(*rows));
    }
    return of;
  }();
  return all;
}

}  // namespace kadr
