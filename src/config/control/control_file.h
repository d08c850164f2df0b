#pragma once
// Loads controls/*.toml as ControlDef. A user's own file may extend a built-in control: `extends = "gost"`, followed by the differences.
// `extends = ["haas", "fanuc-t"]` extends two: the rows of the second are laid over the first, in place of the base that the second names,
// and the alarm numbers are those of the first.

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "base/file_access.h"
#include "config/control/control_def.h"

namespace kadr {

/// Returns the built-in control with this id or alias, in upper or lower case. If `name` ends with .toml, returns the control in this file.
///   door     opens the file and the files that it extends
///   returns  on failure, an error sentence with file and line: unknown key, function, group, word; a code twice; …
tl::expected<ControlDef, std::string> load_control(const std::string& name, const FileAccess* door = nullptr);

/// Like load_control(), but reads the control from TOML text; messages use `file` as the name.
tl::expected<ControlDef, std::string> parse_control(std::string_view toml, const std::string& file);

/// Returns the ids of the built-in controls, sorted.
std::vector<std::string> built_in_controls();

/// Returns the aliases of the built-in controls, sorted, each with its id: "haas-vf" → "haas".
const std::vector<std::pair<std::string, std::string>>& control_aliases();

/// Returns the ids and aliases of the built-in controls: every name that --control accepts.
std::vector<std::string> control_names();

}  // namespace kadr
