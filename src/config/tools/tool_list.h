#pragma once
// Converts tools to JSON and back, with the keys of a tools file. The web page and its session exchange tools as JSON.

#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <tl/expected.hpp>

#include "config/tools/tool_library.h"

namespace kadr {

/// Reads a list of tools: [{"number": 1, "kind": "flat", …}, …].
///   returns  on failure, an error sentence that names the tool
tl::expected<ToolLibrary, std::string> tools_of_list(std::string_view json);

/// Converts a tool to a JSON object.
///   law  tools_of_list() reads the same tool from the result
nlohmann::ordered_json tool_json(const ToolGeometry& tool);

}  // namespace kadr
