#pragma once
// A tool as a table of TOML. For config/tool_library and config/tool_list.

#include <toml++/toml.h>

#include <string>
#include <tl/expected.hpp>

#include "config/tool_library.h"

namespace kadr {

/// returns  an error sentence with its place
tl::expected<ToolGeometry, std::string> tool_of(const std::string& file, const toml::table& row);

/// Each number once; else an error sentence.
tl::expected<void, std::string> add_tool(const std::string& file, const toml::table& row, ToolGeometry tool, ToolLibrary& to);

}  // namespace kadr
