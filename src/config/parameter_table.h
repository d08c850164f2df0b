#pragma once
// controls/NAME-parameters.toml → rows of parameters (nct 24). Such a table belongs to a control (`parameters = "NAME-parameters"` of its
// file) and is none itself.

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "config/control_def.h"

namespace kadr {

/// Whether a file of controls/ is by its name a table of parameters.
bool is_parameter_table(std::string_view name);

/// The built-in table of that name.
///   returns  rows by number, those without one last; an error sentence with file and line: no such table, unknown key,
///            wrong scope, type, class or range, a bit twice
tl::expected<std::vector<ParameterRow>, std::string> load_parameters(const std::string& name);

/// The same from TOML text; `file` names it in messages.
tl::expected<std::vector<ParameterRow>, std::string> parse_parameters(std::string_view toml, const std::string& file);

}  // namespace kadr
