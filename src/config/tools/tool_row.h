#pragma once
// Reads a tool from a TOML table. Used by config/tools/tool_library and config/tools/tool_list.

#include <toml++/toml.h>

#include <string>
#include <tl/expected.hpp>

#include "config/tools/tool_library.h"

namespace kadr {

/// Returns the tool of a TOML row; on failure, an error sentence with the location of the fault.
tl::expected<ToolGeometry, std::string> tool_of(const std::string& file, const toml::table& row);

/// Adds a tool to the library. Returns an error sentence if the library already has a tool with this number.
tl::expected<void, std::string> add_tool(const std::string& file, const toml::table& row, ToolGeometry tool, ToolLibrary& to);

}  // namespace kadr
