// Reads the system variables of a control file: [[variables]].

#include <algorithm>

#include "base/ascii.h"
#include "config/control/control_loader.h"
#include "texts/control_file_variables.h"

namespace kadr {

using toml_tools::place;
using toml_tools::text_of;

namespace {

constexpr std::string_view variable_kinds[] = {
#define KADR_VARIABLE_NAME(name) #name,
    KADR_VARIABLE_KINDS(KADR_VARIABLE_NAME)
#undef KADR_VARIABLE_NAME
};

constexpr std::uint32_t max_number = 2 * first_unwritten_variable;

bool is_symbol(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return is_capital(c) || is_digit(c) || c == '_'; });
}

}  // namespace

Done ControlLoader::variables() {
  const toml::array* const rows = list(file_, "variables");
  if (rows == nullptr) return {};
  for (const auto& node : *rows) {
    const toml::table* const row = node.as_table();
    if (row == nullptr) return Failed(place(name_, node) + translated(texts::control_file_variables::variable_is_table));
    KADR_LOAD(variable(*row));
  }
  return {};
}

Done ControlLoader::variable(const toml::table& row) {
  KADR_LOAD(known_keys(row, {"is", "from", "count", "stride", "repeat", "ranges", "symbol", "first", "arg", "bit", "of", "access", "works",
                             "en", "ru", "manual"}));
  VariableRow v;
  const std::string kind = text(row, "is");
  const auto* const found = std::find(std::begin(variable_kinds), std::end(variable_kinds), kind);
  if (found == std::end(variable_kinds)) {
    return Failed(place(name_, row, "is") + translated(texts::control_file_variables::unknown_kind, kind) +
                  nearest_hint(toml_tools::nearest(kind, {std::begin(variable_kinds), std::end(variable_kinds)})));
  }
  v.kind = static_cast<VariableKind>(found - std::begin(variable_kinds));
  if (row.contains("ranges")) {
    const toml::array* const ranges = row["ranges"].as_array();
    if (ranges == nullptr || ranges->empty())
      return Failed(place(name_, row, "ranges") + translated(texts::control_file_variables::ranges_list));
    for (const auto& node : *ranges) {
      const auto range = variable_range(node);
      if (!range) return Failed(range.error());
      v.ranges.push_back(*range);
    }
    if (row.contains("from")) return Failed(place(name_, row, "from") + translated(texts::control_file_variables::from_or_ranges));
  } else {
    const auto number = [&](const char* key, std::uint32_t otherwise) { return whole(row, key, otherwise, max_variables); };
    v.ranges.push_back({number("from", 0), number("count", 1), number("stride", 0), number("repeat", 1)});
  }
  v.symbol = text(row, "symbol");
  if (row.contains("symbol") && !is_symbol(v.symbol))
    return Failed(place(name_, row, "symbol") + translated(texts::control_file_variables::symbol_letters));
  v.first_index = whole(row, "first", 1, max_variables);
  v.arg = static_cast<int>(whole(row, "arg", 0, max_variables));
  if (row.contains("bit")) v.bit = static_cast<int>(whole(row, "bit", 0, 31));
  v.of = whole(row, "of", 0, max_number);
  const std::string access = row.contains("access") ? text(row, "access") : "RW";
  if (access != "R" && access != "W" && access != "RW")
    return Failed(place(name_, row, "access") + translated(texts::control_file_variables::access_values));
  v.read = access != "W";
  v.write = access != "R";
  v.works = typed(row, "works", true);
  v.text = text_of(row);
  v.manual = text(row, "manual");
  KADR_LOAD(check_variable(row, v));
  def_.variables.push_back(std::move(v));
  return {};
}

/// Reads a range of variable numbers: `[from, count]` or `[from, count, stride, repeat]`.
tl::expected<VariableRange, std::string> ControlLoader::variable_range(const toml::node& node) const {
  const auto wrong = [&] { return Failed(place(name_, node) + translated(texts::control_file_variables::range_values)); };
  const toml::array* const parts = node.as_array();
  if (parts == nullptr || (parts->size() != 2 && parts->size() != 4)) return wrong();
  std::uint32_t numbers[4] = {0, 1, 0, 1};
  for (std::size_t i = 0; i < parts->size(); ++i) {
    const auto number = parts->get(i)->value_exact<std::int64_t>();
    if (!number || *number < 0 || *number > std::int64_t{max_number}) return wrong();
    numbers[i] = static_cast<std::uint32_t>(*number);
  }
  return VariableRange{numbers[0], numbers[1], numbers[2], numbers[3]};
}

}  // namespace kadr
