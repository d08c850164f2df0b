#pragma once
// PanelSheet: what an operator checks before the program continues in the middle: what will be in force, what differs now, and the path.

#include <set>
#include <string>
#include <vector>

#include "panel/panel_search.h"

namespace kadr {

struct PanelSheet {
  /// How an item gets its required value.
  enum class By : std::uint8_t {
    nothing,  // it has it already
    way,      // the axes are moved there
    line,     // by a line of the operator, before the path: tool, spindle, coolant
    memory,   // by restoring the control's memory, as if the program had run
  };
  struct Row {
    std::optional<InForce> wanted, now;
    By by = By::nothing;
    bool may_be_left = false;  // the present value may be kept
  };
  std::vector<Row> rows;
  std::vector<WayPoint> way;
  RestartBlocks blocks;  // blocks that restore all of it, for another machine with this control
};

/// Identifies an item in force, for selection: its kind and its name.
std::string key_of(const InForce& one);

/// The sheet of one channel, from the present position of its axes and what is in force.
///   in_block  the program continues in the middle of a block
///   alarms    word_has_no_room
Result<PanelSheet> sheet_of(const Restart& restart, bool in_block, const ToolPosition& stand, const std::vector<InForce>& now,
                            const WayRules& rules, const Control& control, const ControlDef& def);

/// The lines to execute before the path.
///   left     keys of items that keep their present value
///   alarms   word_has_no_room
Result<std::vector<std::string>> lines_before(const PanelSheet& sheet, const std::set<std::string>& left, const ControlDef& def);
/// The lines that set the kept items again, after the control's memory has been restored as the program has it.
Result<std::vector<std::string>> lines_after(const PanelSheet& sheet, const std::set<std::string>& left, const ControlDef& def);

}  // namespace kadr
