// Reads the section [guess] of control files, and of the program languages in controls/dialects.toml. Used by config/control/guess and
// config/control/control_loader_words; tested by tests/config/guess_test.cpp.

#include "config/control/guess_rows.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <optional>

#include "config/control/control_file.h"
#include "config/control/guess_section.h"
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

/// Returns the rows of the section [guess] in the file of a built-in control; nullopt if it has no such section.
std::optional<GuessRows> rows_in_file(const std::string& id) {
  const std::string file = "controls/" + id + ".toml";
  const auto table = toml_tools::embedded_sections(file, {"guess"});
  const toml::table* const guess = table ? (*table)["guess"].as_table() : nullptr;
  if (guess == nullptr) return std::nullopt;
  auto rows = guess_rows_of(*guess, file);
  // The [guess] section of a built-in control is always valid, because tests/controls_table.py loads every built-in file
  assert(rows);
  rows->control = id;
  return std::move(*rows);
}

/// Adds the rows of `base` whose patterns and traits `rows` does not have.
void add_rows(GuessRows& rows, const GuessRows& base) {
  const auto has_mark = [&rows](const GuessMark& mark) {
    return std::any_of(rows.marks.begin(), rows.marks.end(),
                       [&](const GuessMark& own) { return own.pattern == mark.pattern && own.place == mark.place; });
  };
  std::vector<GuessMark> more;
  std::copy_if(base.marks.begin(), base.marks.end(), std::back_inserter(more), [&](const GuessMark& mark) { return !has_mark(mark); });
  rows.marks.insert(rows.marks.end(), more.begin(), more.end());
  const auto has_trait = [&rows](TextTrait trait) {
    return std::any_of(rows.traits.begin(), rows.traits.end(), [&](const auto& own) { return own.first == trait; });
  };
  for (const auto& row : base.traits)
    if (!has_trait(row.first)) rows.traits.push_back(row);
}

/// Reads `read_by` of a program language in controls/dialects.toml.
std::vector<LanguageReader> readers_of(const toml::table& table, const std::string& file) {
  std::vector<LanguageReader> readers;
  for (const auto& [control, node] : table) {
    const toml::table& reader = *node.as_table();
    auto rows = guess_rows_of(*reader["guess"].as_table(), file);
    assert(rows);  // always valid, because tests/config/guess_test.cpp reads all of them
    readers.push_back({std::string(control.str()), reader["mill"].value_or(std::string()), std::move(*rows)});
  }
  return readers;
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

void add_rows_of_language(GuessRows& rows, std::string_view control) {
  for (const GuessRows& language : dialect_rows())
    for (const LanguageReader& reader : language.read_by) {
      if (reader.id != control) continue;
      add_rows(rows, reader.rows);
      add_rows(rows, language);
      if (const auto mill = rows_in_file(reader.mill)) add_rows(rows, *mill);
    }
}

const std::vector<GuessRows>& built_in_guess_rows() {
  static const std::vector<GuessRows> all = [] {
    std::vector<GuessRows> of;
    for (const std::string& id : built_in_controls()) {
      GuessRows rows = rows_in_file(id).value_or(GuessRows{});
      rows.control = id;
      add_rows_of_language(rows, id);
      if (!rows.marks.empty()) of.push_back(std::move(rows));
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
      if (const toml::table* const by = dialect["read_by"].as_table()) rows->read_by = readers_of(*by, file);
      of.push_back(std::move(*rows));
    }
    return of;
  }();
  return all;
}

}  // namespace kadr
