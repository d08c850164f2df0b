#pragma once
// PanelSheet: the list that an operator checks before a program continues in the middle: the modes, tool and offsets that the block
// requires, which of them differ now, and the path to the block.

#include <set>
#include <string>
#include <vector>

#include "panel/panel_search.h"

namespace kadr {

struct PanelSheet {
  /// How an item on the sheet gets its required value.
  enum class By : std::uint8_t {
    nothing,  // the item already has the required value
    way,      // the axes move to the required position
    line,     // a line sets the value before the axes move: tool, spindle, coolant
    memory,   // the value is set when the control's memory is restored, as if the program had run
  };
  struct Row {
    std::optional<InForce> wanted, now;
    By by = By::nothing;
    bool may_be_left = false;  // the operator may choose to keep the present value
  };
  std::vector<Row> rows;
  std::vector<WayPoint> way;
  RestartBlocks blocks;  // blocks that set everything required, for another machine with the same control
};

/// Returns the key by which a request names an item of the sheet: its kind and its name.
std::string key_of(const InForce& one);

/// Creates the sheet of one channel from the present position of its axes and the present modes.
///   in_block  true: the program continues in the middle of a block
///   alarms    word_has_no_room
Result<PanelSheet> sheet_of(const Restart& restart, bool in_block, const ToolPosition& stand, const std::vector<InForce>& now,
                            const WayRules& rules, const Control& control, const ControlDef& def);

/// Returns the lines that the control must execute before the axes move to the block.
///   left     keys of items that keep their present value
///   alarms   word_has_no_room
Result<std::vector<std::string>> lines_before(const PanelSheet& sheet, const std::set<std::string>& left, const ControlDef& def);
/// Returns the lines that the control must execute after the restart, to set again the items that the operator keeps: restoring the
/// control's memory sets every item to the program's value.
Result<std::vector<std::string>> lines_after(const PanelSheet& sheet, const std::set<std::string>& left, const ControlDef& def);

}  // namespace kadr
