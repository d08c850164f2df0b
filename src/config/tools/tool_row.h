#pragma once
// Reads a tool from a TOML table. Used by config/tools/tool_library and config/tools/tool_list.

#include <toml++/toml.h>

#include <string>
#include <tl/expected.hpp>

#include "config/tools/tool_library.h"

namespace kadr {

/// Returns the tool of a row; on failure, an error sentence with its location.
tl::expected<ToolGeometry, std::string> tool_of(const std::string& file, const toml::table& row);

/// Adds a tool. Returns an error sentence if its number occurs already.
tl::expected<void, std::string> add_tool(const std::string& file, const toml::table& row, ToolGeometry tool, ToolLibrary& to);

}  // namespace kadr
