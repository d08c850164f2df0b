// PanelSheet is the list that an operator checks before a restart. Used by panel/panel_machine; tested by
// tests/panel/panel_restart_test.cpp.

#include "panel/panel_sheet.h"

#include <algorithm>
#include <array>
#include <utility>

namespace kadr {
namespace {

using Kind = InForce::Kind;

constexpr std::array kinds = {"position", "machine", "code",          "feed",   "speed",  "spindle",  "coolant", "tool",
                              "selected", "offset",  "length_offset", "origin", "length", "rotation", "scale",   "variable"};

const CodeRow* row_of(const InForce& one, const ControlDef& def) {
  const auto found = std::find_if(def.codes.begin(), def.codes.end(), [&](const CodeRow& row) { return row.code == one.code; });
  return one.kind != Kind::code || found == def.codes.end() ? nullptr : &*found;
}

/// True if the machine executes this item (tool, spindle, coolant). False if the item changes only the control's memory.
bool is_done_by_machine(const InForce& one, const ControlDef& def) {
  switch (one.kind) {
    case Kind::tool:
    case Kind::speed:
    case Kind::spindle:
    case Kind::coolant: return true;
    default: break;
  }
  const CodeRow* const row = row_of(one, def);
  if (row == nullptr) return false;
  constexpr std::array phases = {Phase::spindle, Phase::spindle_stop, Phase::coolant, Phase::coolant_off};
  return std::find(phases.begin(), phases.end(), row->phase) != phases.end();
}

PanelSheet::By by_what(const InForce& one, const ControlDef& def) {
  if (one.kind == Kind::position || one.kind == Kind::machine) return PanelSheet::By::path;
  return is_done_by_machine(one, def) ? PanelSheet::By::line : PanelSheet::By::memory;
}

/// Returns the blocks that set exactly these items. The list is empty if no block can set one of the items.
Result<std::vector<std::string>> lines_of(const std::vector<InForce>& things, const ControlDef& def) {
  auto blocks = restart_blocks(def, things, things, {});
  if (!blocks) return fail(blocks.error());
  return std::move(blocks->blocks);
}

/// True if the operator may keep the present value of the item. This is allowed if a line can set the value after the restart, and if the
/// item affects neither how the tool moves nor the location of the tool's path.
bool may_be_left(const PanelSheet::Row& row, const ControlDef& def) {
  if (!row.required || !row.now) return false;
  switch (row.now->kind) {
    case Kind::tool:
    case Kind::speed:
    case Kind::spindle:
    case Kind::coolant:
    case Kind::feed:
    case Kind::variable: break;
    default:
      if (!is_done_by_machine(*row.now, def)) return false;
  }
  const auto blocks = restart_blocks(def, {*row.now}, {*row.now}, {});
  return blocks && !blocks->blocks.empty() && blocks->by_hand.empty();
}

}  // namespace

std::string key_of(const InForce& one) { return std::string(kinds[std::size_t(one.kind)]) + ":" + one.name; }

Result<PanelSheet> sheet_of(const Restart& restart, bool in_block, const ToolPosition& stand, const std::vector<InForce>& now,
                            const WayRules& rules, const Control& control, const ControlDef& def) {
  PanelSheet sheet;
  const std::vector<InForce>& required = restart.in_force;
  std::vector<Difference> all = differences(required, now);
  std::vector<InForce> to_set;
  for (const InForce& one : required) {
    const auto differs = std::find_if(all.begin(), all.end(), [&](const Difference& d) { return d.required == one; });
    PanelSheet::Row& row = sheet.rows.emplace_back(PanelSheet::Row{one, one});
    if (differs == all.end()) continue;
    to_set.push_back(one);
    row.now = differs->now;
    row.by = by_what(one, def);
    row.may_be_left = !in_block && may_be_left(row, def);
  }
  for (Difference& d : all)
    if (!d.required) sheet.rows.push_back({std::nullopt, std::move(d.now), PanelSheet::By::memory});
  sheet.path = path_there(stand, restart, rules, control.axes().size());
  auto blocks = restart_blocks(def, to_set, required, in_work_coordinates(sheet.path, restart, def));
  if (!blocks) return fail(blocks.error());
  sheet.blocks = std::move(*blocks);
  return sheet;
}

Result<std::vector<std::string>> lines_before(const PanelSheet& sheet, const std::set<std::string>& left, const ControlDef& def) {
  const auto is_left = [&](const PanelSheet::Row& row) { return row.may_be_left && left.contains(key_of(*row.required)); };
  const bool changes_tool = std::any_of(sheet.rows.begin(), sheet.rows.end(), [&](const PanelSheet::Row& row) {
    return row.by == PanelSheet::By::line && row.required->kind == Kind::tool && !is_left(row);
  });
  std::vector<InForce> things;
  for (const PanelSheet::Row& row : sheet.rows) {
    // A tool change may stop the spindle or the coolant, so these must start again.
    const bool again = changes_tool && row.required && is_done_by_machine(*row.required, def);
    if ((row.by == PanelSheet::By::line || again) && !is_left(row)) things.push_back(*row.required);
  }
  return lines_of(things, def);
}

Result<std::vector<std::string>> lines_after(const PanelSheet& sheet, const std::set<std::string>& left, const ControlDef& def) {
  std::vector<InForce> things;
  for (const PanelSheet::Row& row : sheet.rows)
    if (row.may_be_left && left.contains(key_of(*row.required))) things.push_back(*row.now);
  return lines_of(things, def);
}

}  // namespace kadr
