#pragma once
// Makes an insert from the row of a lathe's offset table, for tools that no tools file describes. It is used by
// session/cutting/turned_cutting and view/proposals.

#include <optional>

#include "config/control/control_def.h"
#include "config/setup/setup.h"
#include "config/tools/tool_geometry.h"

namespace kadr {

/// How an offset table numbers the imaginary tip: as Fanuc and NCT in the plane Z X (spec/fanuc-t 7.1), or as LinuxCNC
/// (docs/commands/cut.md, "Turning tools").
enum class TipNumbers : std::uint8_t { fanuc, linuxcnc };
TipNumbers tip_numbers(const ControlDef& def);

/// True if the row of this control may be that of a turning tool. On a control that is not a lathe's, a row with tip 0 is that of a mill.
bool states_insert(const ControlDef& def, const ToolOffset& row);

/// Returns an insert with the nose radius and the imaginary tip of the row (spec/fanuc-t 7.1).
///   tips 1 to 4   (numbers of Fanuc) the table does not state the form of the insert: 55° with an entering angle of 93°, edges 10 mm long
///   (ours) tips 5 to 8   35°, its bisector away from the tip (ours) tips 0 and 9  a round insert of the nose radius returns       nullopt
///   if the row states neither a tip nor a radius: nothing is known of the tool
std::optional<ToolGeometry> insert_of_offset(const ToolOffset& row, std::uint32_t tool, TipNumbers numbers = TipNumbers::fanuc);

}  // namespace kadr
