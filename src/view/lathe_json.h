#pragma once
// Converts what the panel of a lathe shows to JSON (docs/panel-protocol.md: State, Panel). It is used by view/panel_json and
// view/page/page_json.

#include <string>
#include <vector>

#include "control/lathe_modes.h"
#include "view/page/page_json.h"

namespace kadr {

/// Returns the names of the axes in diameter programming.
PageJson diameters_json(const std::vector<std::string>& axes, AxisMask diameters);

/// Adds the keys diameters, feed_per_turn, surface and tool_offset. With constant surface speed the key rpm is replaced by the speed of the
/// spindle at the tool's place, null if nothing limits it there.
///   work      work coordinates of the tool at present, mm or degrees
///   most_rpm  highest speed of the machine's spindle, rev/min; 0: unknown
///   is_lathe  the control is that of a lathe; tool_offset is null on others unless an axis is in diameter programming
void put_lathe(PageJson& json, const LatheModes& modes, const std::vector<std::string>& axes, const Axes& work, double most_rpm,
               bool is_lathe);

}  // namespace kadr
