#pragma once
// Tools ↔ JSON, the keys those of a tools file: what a page and a session tell each other of tools.

#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <tl/expected.hpp>

#include "config/tool_library.h"

namespace kadr {

/// [{"number": 1, "kind": "flat", …}, …]
///   returns  an error sentence that names the tool
tl::expected<ToolLibrary, std::string> tools_of_list(std::string_view json);

/// law  tools_of_list() makes the same tool of it
nlohmann::ordered_json tool_json(const ToolGeometry& tool);

}  // namespace kadr
