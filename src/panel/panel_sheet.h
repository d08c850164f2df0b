#pragma once
// PanelSheet is the list that an operator checks before a program continues in mid-program. It states the modes, the tool and the offsets
// that the block requires, which of these differ at present, and the path to the block.

#include <set>
#include <string>
#include <vector>

#include "panel/panel_search.h"

namespace kadr {

struct PanelSheet {
  /// How an item on the sheet gets its required value.
  enum class By : std::uint8_t {
    nothing,  // the present value is the required value, so nothing must be done
    path,     // the axes move along a path to the required position
    line,     // a line sets the value before the axes move: tool, spindle, coolant
    memory,   // the value is set when the control's memory is restored, as if the program had been executed
  };
  struct Row {
    std::optional<InForce> required, now;
    By by = By::nothing;
    bool may_be_left = false;  // true if the operator may choose to keep the present value of the item
  };
  std::vector<Row> rows;
  std::vector<WayPoint> path;
  RestartBlocks blocks;  // The program blocks that set everything the restart requires, for use on another machine with the same control.
};

/// Returns the key with which a request names an item of the sheet. The key consists of the item's kind and name.
std::string key_of(const InForce& one);

/// Returns the sheet of one channel for the present position of its axes and the present modes.
///   in_block  true: the program continues in the middle of a block
///   alarms    word_has_no_room
Result<PanelSheet> sheet_of(const Restart& restart, bool in_block, const ToolPosition& stand, const std::vector<InForce>& now,
                            const WayRules& rules, const Control& control, const ControlDef& def);

/// Returns the lines that the control must execute before the axes move to the block.
///   left     keys of items that keep their present value
///   alarms   word_has_no_room
Result<std::vector<std::string>> lines_before(const PanelSheet& sheet, const std::set<std::string>& left, const ControlDef& def);
/// Returns the lines that the control must execute after the restart. These lines restore the items whose present value the operator keeps,
/// because restoring the control's memory sets every item to the program's value.
Result<std::vector<std::string>> lines_after(const PanelSheet& sheet, const std::set<std::string>& left, const ControlDef& def);

}  // namespace kadr
