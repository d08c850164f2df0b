#pragma once
// The keys of a turning tool in tools files, and the conditions that an insert must meet (docs/commands/cut.md). Used by
// config/tools/tool_library.

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "config/tools/tool_geometry.h"

namespace kadr {

namespace limits {
inline constexpr std::size_t insert_points = 64;  // greatest number of points in the profile or in the holder of a turning tool
}

/// Reads the keys points, lead, width, profile and holder of a turning tool.
tl::expected<void, std::string> insert_of(const std::string& file, const toml::table& row, InsertGeometry& insert);

/// Returns the value of the key `points` that describes this insert: "-x-z", "centre".
std::string_view name_of_tip(const InsertGeometry& insert);

/// Sets values that the file does not state: `flutes` of a round insert to its diameter, and the entering angle `lead`. The entering angle
/// is set so that the bisector of the nose points straight away from the tip. For a grooving insert, it is 0° or 90°, depending on the
/// direction of the tip.
void complete_insert(ToolGeometry& tool);

/// Returns a message that says why the shape of the turning tool is not valid; empty if the shape is valid.
std::string insert_fault_message(const ToolGeometry& tool);

}  // namespace kadr
