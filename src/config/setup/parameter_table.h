#pragma once
// Reads controls/NAME-parameters.toml as rows of parameters (nct 24). A control names this table in its file (`parameters =
// "NAME-parameters"`); the table itself is no control.

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "config/control/control_def.h"

namespace kadr {

/// Returns true if a file of controls/ with this name is a parameter table.
bool is_parameter_table(std::string_view name);

/// Returns the built-in table with this name. A table may have the key `extends`, which names a table whose rows it inherits; a row with
/// the value `false` removes an inherited row.
///   returns  rows sorted by number, those without a number last; on failure, an error sentence with file and line: no such table,
///            unknown key, wrong scope, type, class or range, duplicate bit
tl::expected<std::vector<ParameterRow>, std::string> load_parameters(const std::string& name);

/// Reads a parameter table from TOML text, as load_parameters() reads a built-in one. `file` is the name that messages use for the text.
tl::expected<std::vector<ParameterRow>, std::string> parse_parameters(std::string_view toml, const std::string& file);

}  // namespace kadr
