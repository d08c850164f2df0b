// Reads the names of a control from its file: `aliases` and [guess]. Tested by tests/config/control_rules_test.cpp.

#include <algorithm>
#include <utility>

#include "config/control/control_file.h"
#include "config/control/control_loader.h"
#include "config/control/guess_rows.h"

namespace kadr {

using loader_texts::say;
using toml_tools::place;

namespace {

/// Returns all names that mean a built-in control, each with the control's id.
std::vector<std::pair<std::string, std::string>> taken_names() {
  std::vector<std::pair<std::string, std::string>> names = control_aliases();
  for (const std::string& id : built_in_controls()) names.emplace_back(id, id);
  return names;
}

}  // namespace

/// Reads `aliases`, and [guess]: the marks by which a text is recognised.
Done ControlLoader::names() {
  const auto is_name = [](const std::string& word) {
    return !word.empty() && word.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-.") == std::string::npos &&
           !word.ends_with(".toml");
  };
  if (const toml::array* const aliases = list(file_, "aliases"); aliases != nullptr)
    for (const toml::node& node : *aliases) {
      const auto alias = node.value_exact<std::string>();
      if (!alias) return Failed(place(name_, node) + say("aliases: a list of texts"));
      if (!is_name(*alias)) return Failed(place(name_, node) + say("aliases: '{}' is not a name: small letters, digits, - and .", *alias));
      if (std::find(def_.aliases.begin(), def_.aliases.end(), *alias) != def_.aliases.end())
        return Failed(place(name_, node) + say("aliases: '{}' stands twice", *alias));
      if (node.source().path)  // tests/controls_table.py has checked the packed built-in files, which have no path
        for (const auto& [other, id] : taken_names())
          if (other == *alias && id != def_.id)
            return Failed(place(name_, node) + say("aliases: '{}' is the name of another control: {}", *alias, id));
      def_.aliases.push_back(*alias);
    }
  KADR_LOAD(no_effect(file_, "aliases", say("aliases have no effect in a file of your own: it is named by its path")));
  const toml::table* const guess = section("guess");
  if (guess == nullptr) return {};
  if (const auto rows = guess_rows_of(*guess, name_); !rows) return Failed(rows.error());
  return {};
}

}  // namespace kadr
