// Converts rows of the state file to tables of a set-up and back. The keys of both are the same, so the reader of set-ups also checks the
// rows.

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <tuple>

#include "config/json_text.h"
#include "config/state/state_file.h"
#include "config/state/state_json.h"

namespace kadr {
namespace {

using Json = nlohmann::json;

/// Returns true if the rows of this set-up table have several values ("5/length"), false if a row is a single value.
constexpr bool has_columns(StateTable table) {
  return table == StateTable::offsets || table == StateTable::work_offsets || table == StateTable::tool_table ||
         table == StateTable::form_table;
}

std::string name_of(StateTable table) { return std::string(state_table_names[static_cast<std::size_t>(table)]); }

void put(std::vector<StateRow>& rows, StateTable table, const std::string& key, const Json& value) {
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) put(rows, table, key + "/" + std::to_string(i + 1), value[i]);
  } else if (value.is_string()) {
    rows.push_back({table, key, value.get<std::string>()});
  } else if (value.is_number()) {
    rows.push_back({table, key, value.get<double>()});
  }
}

Json to_json(const StateValue& value) {
  if (const auto* const text = std::get_if<std::string>(&value)) return *text;
  if (const auto* const number = std::get_if<double>(&value)) return *number;
  return nullptr;
}

/// Stores a value under its key in the set-up: for "5/length" in table[5].length, for "2/user/3" in the third element of the list
/// table[2].user.
void put(Json& table, const std::string& key, const Json& value) {
  const std::size_t first = key.find('/');
  const std::string row = key.substr(0, first), rest = first == std::string::npos ? "" : key.substr(first + 1);
  if (!rest.starts_with("user/")) {
    table[row][rest] = value;
    return;
  }
  Json& list = table[row]["user"];
  const std::size_t number = rest.size() < 8 ? std::strtoul(rest.c_str() + 5, nullptr, 10) : 0;
  while (list.size() < std::min(number, ToolRow{}.user.size())) list.push_back(0);
  if (number > 0 && number <= list.size()) list[number - 1] = value;
  // For an invalid row, stores the value under the whole key; the reader of set-ups then rejects the key by name
  else table[row][rest] = value;
}

}  // namespace

void sort_rows(std::vector<StateRow>& rows) {
  std::sort(rows.begin(), rows.end(),
            [](const StateRow& a, const StateRow& b) { return std::tie(a.table, a.key) < std::tie(b.table, b.key); });
}

std::vector<StateRow> rows_of(const Setup& tables) {
  const Json state = json_of(state_json({tables, {}, {}}));
  std::vector<StateRow> rows;
  for (std::size_t t = 0; t < state_table_names.size(); ++t) {
    const auto table = static_cast<StateTable>(t);
    const Json content = state.value(name_of(table), Json::object());
    for (const auto& [key, value] : content.items()) {
      if (!has_columns(table)) put(rows, table, key, value);
      else
        for (const auto& [column, item] : value.items()) put(rows, table, key + "/" + column, item);
    }
  }
  for (const auto& [name, value] : tables.variables)
    if (value) rows.push_back({StateTable::variables, name, *value});
  sort_rows(rows);
  return rows;
}

tl::expected<Setup, std::string> setup_of(const StoredState& state) {
  Json setup = Json::object();
  for (const StateRow& row : state.rows) {
    Json& table = setup[name_of(row.table)];
    if (has_columns(row.table)) put(table, row.key, to_json(row.value));
    else table[row.key] = to_json(row.value);
  }
  return parse_setup(json_text(setup));
}

}  // namespace kadr
