#pragma once
// What an operator looks at before his program goes on in the middle: what will be in force, what is otherwise now, the way there.

#include <set>
#include <string>
#include <vector>

#include "panel/panel_search.h"

namespace kadr {

struct PanelSheet {
  /// How something comes to what it must be.
  enum class By : std::uint8_t {
    nothing,  // it is so
    way,      // the axes are led there
    line,     // a line of the operator, before the way: tool, spindle, coolant
    memory,   // the control remembers it as if the program had run
  };
  struct Row {
    std::optional<InForce> wanted, now;
    By by = By::nothing;
    bool may_be_left = false;  // as it is now
  };
  std::vector<Row> rows;
  std::vector<WayPoint> way;
  RestartBlocks blocks;  // that bring all of it, for another machine with this control
};

/// Of a thing that is in force, for whoever chooses among them: its kind and its name.
std::string key_of(const InForce& one);

/// Of one channel, from where its axes stand, and what is in force there.
///   in_block  it goes on in the middle of a block
///   alarms    word_has_no_room
Result<PanelSheet> sheet_of(const Restart& restart, bool in_block, const ToolPosition& stand, const std::vector<InForce>& now,
                            const WayRules& rules, const Control& control, const ControlDef& def);

/// Lines before the way.
///   left     keys of what stays as it is now
///   alarms   word_has_no_room
Result<std::vector<std::string>> lines_before(const PanelSheet& sheet, const std::set<std::string>& left, const ControlDef& def);
/// Lines that bring back what is left, when the control remembers all as the program has it.
Result<std::vector<std::string>> lines_after(const PanelSheet& sheet, const std::set<std::string>& left, const ControlDef& def);

}  // namespace kadr
