#pragma once
// controls/*.toml → ControlDef. A user's own file may extend a built-in one: `extends = "gost"` and the differences.

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "base/file_door.h"
#include "config/control_def.h"

namespace kadr {

/// The control with that id or alias, in small letters or capitals, or in that file if `name` ends with .toml.
///   door     opens such files, and what they extend
///   returns  an error sentence with file and line: unknown key, function, group, word; a code twice; …
tl::expected<ControlDef, std::string> load_control(const std::string& name, const FileDoor* door = nullptr);

/// The same from TOML text; `file` names it in messages.
tl::expected<ControlDef, std::string> parse_control(std::string_view toml, const std::string& file);

/// Ids of the built-in controls.
std::vector<std::string> built_in_controls();

/// The other names of the built-in controls, in order, and the ids that they mean: "haas-vf" → "haas".
const std::vector<std::pair<std::string, std::string>>& control_aliases();

/// Ids and aliases: all that may stand behind --control.
std::vector<std::string> control_names();

}  // namespace kadr
