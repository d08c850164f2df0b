// Reads the sections [names] and [cycle_parameters] of a control file. Used by out/text/explain; tested by
// tests/out/name_text_test.cpp.

#include "config/control/control_names.h"

#include <algorithm>
#include <map>
#include <sstream>

#include "base/ascii.h"
#include "config/control/control_file.h"
#include "config/tools/toml_tools.h"

namespace kadr {
namespace {

Text text_in(const toml::table& row) { return {row["en"].value_or(std::string()), row["ru"].value_or(std::string())}; }

std::vector<NameParameter> parameters_of(const std::string& cycle, const std::string& list, const toml::table* meanings) {
  std::vector<NameParameter> all;
  std::istringstream words(list);
  for (std::string name; words >> name;) {
    NameParameter parameter{name, {}};
    for (const std::string& key : {name, cycle + "." + name})  // the row of the cycle itself decides
      if (const toml::table* const row = meanings == nullptr ? nullptr : (*meanings)[key].as_table()) parameter.text = text_in(*row);
    all.push_back(std::move(parameter));
  }
  return all;
}

std::vector<NameRow> names_in_file(const std::string& id) {
  std::vector<NameRow> all;
  const auto table = toml_tools::embedded_sections("controls/" + id + ".toml", {"names", "cycle_parameters"});
  const toml::table* const names = table ? (*table)["names"].as_table() : nullptr;
  if (names == nullptr) return all;
  const toml::table* const meanings = (*table)["cycle_parameters"].as_table();
  for (const auto& [key, node] : *names) {
    const toml::table& row = *node.as_table();
    const std::string name(key.str());
    all.push_back({name, text_in(row), row["manual"].value_or(std::string()), row["works"].value_or(true),
                   parameters_of(name, row["parameters"].value_or(std::string()), meanings)});
  }
  return all;
}

}  // namespace

const std::vector<NameRow>& named_rows(const ControlDef& def) {
  static const std::vector<NameRow> none;
  if (!def.grammar.named_blocks && !def.grammar.klartext_blocks) return none;
  static const std::map<std::string, std::vector<NameRow>> rows = [] {
    std::map<std::string, std::vector<NameRow>> all;
    for (const std::string& id : built_in_controls()) {
      auto names = names_in_file(id);
      if (!names.empty()) all.emplace(id, std::move(names));
    }
    return all;
  }();
  if (const auto own = rows.find(def.id); own != rows.end()) return own->second;
  for (const std::string& base : def.lineage)
    if (const auto found = rows.find(base); found != rows.end()) return found->second;
  return none;
}

const NameRow* named_row(const ControlDef& def, std::string_view name) {
  const auto& rows = named_rows(def);
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const NameRow& row) {
    return row.name.size() == name.size() &&
           std::equal(name.begin(), name.end(), row.name.begin(), [](char a, char b) { return to_upper(a) == b; });
  });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace kadr
