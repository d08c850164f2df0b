#pragma once
// SetupUse: what a program uses of a set-up, with the figures that its comments propose. `kadr setup` writes it as a template, the page
// shows it as a form.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "session/session.h"
#include "session/tool_proposals.h"
#include "session/used_key.h"

namespace kadr {

/// The results of executing a program for its uses.
struct ExecutedBlocks {
  std::size_t faults = 0;
  MotionUnits moved;
};

/// Executes the program and continues after faults, as in `kadr check`; gives up after 1000 faults. Programs of other channels are not
/// executed, so the program does not wait for them.
///   pre  the set-up of the session has no other channels; nothing of the program has been executed
ExecutedBlocks execute_for_use(Session& session, const StopToken& stop);

/// One use of the set-up by the program.
struct SetupUseRow {
  struct Cell {
    std::string key;                 // "length"; empty: the row itself is the value
    std::optional<double> proposed;  // mm
  };
  Use use;
  UsedKey used;
  std::string table;                 // "offsets", "work_offsets", "zeros", "correctors", "variables"; empty: a switch or a tool
  std::string row;                   // "1", "G54", "#500"
  std::vector<Cell> cells;           // values of the row that the program uses
  std::optional<ToolProposal> by{};  // of a radius or a tool: the comment that states its size
  // of a radius or a tool: a comment that describes the tool without a certain size; only if there is no `by`
  std::optional<ToolProposal> unsure{};
};

struct SetupUse {
  std::vector<SetupUseRow> rows;  // in the order of their first use; a value is in one row only
  std::size_t faults = 0;         // how many faults the program has: what would follow them may be missing
  // Ranges of lines of the main program that were not executed, because no jump or condition led to them.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> not_executed;
};

/// Returns what the program has used.
///   pre  watch_use() of the control was called before the run
SetupUse setup_use(const Control& control, const ControlDef& def, const ExecutedBlocks& done);

}  // namespace kadr
