#pragma once
// The keys of a turning tool in tools files, and what an insert must be (docs/commands/cut.md). For config/tool_library.

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "config/tool_geometry.h"

namespace kadr {

namespace limits {
inline constexpr std::size_t insert_points = 64;  // of a profile or holder of a turning tool
}

/// points, lead, width, profile, holder.
tl::expected<void, std::string> insert_of(const std::string& file, const toml::table& row, InsertGeometry& insert);

/// What `points` says of it: "-x-z", "centre".
std::string_view name_of_tip(const InsertGeometry& insert);

/// What follows from the rest: a bisector straight behind the tip.
void complete_insert(ToolGeometry& tool);

/// Why a turning tool has no shape, told; empty: it has one.
std::string told_insert_fault(const ToolGeometry& tool);

}  // namespace kadr
