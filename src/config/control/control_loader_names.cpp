// Reads the names of a control from its file: `aliases` and [guess]. Tested by tests/config/control_rules_test.cpp.

#include <algorithm>
#include <utility>

#include "config/control/control_file.h"
#include "config/control/control_loader.h"
#include "config/control/guess_section.h"
#include "texts/control_file.h"

namespace kadr {

using toml_tools::place;

namespace {

/// Returns all names of built-in controls, each with the id of its control.
std::vector<std::pair<std::string, std::string>> taken_names() {
  std::vector<std::pair<std::string, std::string>> names = control_aliases();
  for (const std::string& id : built_in_controls()) names.emplace_back(id, id);
  return names;
}

}  // namespace

/// Reads `aliases`, and [guess]: the patterns by which a program for this control is recognised.
Done ControlLoader::names() {
  const auto is_name = [](const std::string& word) {
    return !word.empty() && word.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-.") == std::string::npos &&
           !word.ends_with(".toml");
  };
  if (const toml::array* const aliases = list(file_, "aliases"); aliases != nullptr)
    for (const toml::node& node : *aliases) {
      const auto alias = node.value_exact<std::string>();
      if (!alias) return Failed(place(name_, node) + translated(texts::control_file::aliases_list));
      if (!is_name(*alias)) return Failed(place(name_, node) + translated(texts::control_file::alias_is_no_name, *alias));
      if (std::find(def_.aliases.begin(), def_.aliases.end(), *alias) != def_.aliases.end())
        return Failed(place(name_, node) + translated(texts::control_file::alias_twice, *alias));
      // Only a user's own control file has a path and is checked here; tests/controls_table.py has checked the built-in files
      if (node.source().path)
        for (const auto& [other, id] : taken_names())
          if (other == *alias && id != def_.id)
            return Failed(place(name_, node) + translated(texts::control_file::alias_of_another, *alias, id));
      def_.aliases.push_back(*alias);
    }
  KADR_LOAD(no_effect(file_, "aliases", translated(texts::control_file::aliases_of_own_file)));
  const toml::table* const guess = section("guess");
  if (guess == nullptr) return {};
  if (const auto rows = guess_rows_of(*guess, name_); !rows) return Failed(rows.error());
  return {};
}

}  // namespace kadr
