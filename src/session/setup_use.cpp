// SetupUse: finds what a program uses of a set-up. Used by cli/setup_command and view/page/page_setup; tested by tests/setup_command.py and
// tests/serve_setup.py.

#include "session/setup_use.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>

#include "action/by_kind.h"
#include "config/setup/setup_names.h"

namespace kadr {
namespace {

constexpr std::size_t gives_up_at = 1000;

bool is_of_lathe(const ControlDef& def) { return def.behaviour.lathe != Lathe::none; }

/// True if the line contains a block that the control executes, not only % or the number of the program.
bool holds_block(const std::string& text) {
  const std::string rest = without_comments(text);
  if (rest.empty() || rest[0] == '%') return false;
  const bool is_name = (rest[0] == 'O' || rest[0] == ':') && rest.find_first_not_of("0123456789 ", 1) == std::string::npos;
  return !is_name;
}

class UseReader {
 public:
  UseReader(const Control& control, const ControlDef& def, const ExecutedBlocks& done)
      : control_(control),
        def_(def),
        lines_(lines_of(control)),
        proposals_(lines_, comments_in_inches(control, done.moved), is_of_lathe(def)) {
    found_.faults = done.faults;
  }

  SetupUse read() {
    for (const Use& use : control_.use().all()) take(use);
    find_not_executed();
    return std::move(found_);
  }

 private:
  void take(const Use& use) {
    SetupUseRow row{use, used_key(use, def_), {}, {}, {}};
    const std::size_t dot = row.used.key.find('.');
    if (dot != std::string::npos) {
      row.table = row.used.key.substr(0, dot);
      row.row = row.used.key.substr(dot + 1);
    }
    switch (use.kind) {
      case UseKind::tool: take_tool(row); break;
      case UseKind::length:
      case UseKind::radius: take_offset(row); break;
      case UseKind::work_zero: add_axes(row); break;
      case UseKind::corrector:
      case UseKind::variable:
      case UseKind::parameter: row.cells.push_back({"", std::nullopt}); break;
      default: break;
    }
    const bool is_known = (use.kind == UseKind::length || use.kind == UseKind::radius) && row.cells.empty();
    if (!is_known) found_.rows.push_back(std::move(row));
  }

  void take_tool(SetupUseRow& row) {
    called_.emplace(row.use.number, row.use);
    find_comment(row, row.use.number);
  }

  /// A lathe's row has geometry and wear of each axis, or the nose radius with the number of the imaginary tip, which only nose radius
  /// compensation uses (fanuc-t 4.2). A comment's size is not proposed there, because it is seldom that of the nose.
  void take_offset(SetupUseRow& row) {
    row.row = std::to_string(row.use.number);
    const bool is_radius = row.use.kind == UseKind::radius;
    if (is_of_lathe(def_)) {
      if (is_radius) row.cells = {{"radius", std::nullopt}, {"tip", std::nullopt}};
      else add_geometry(row);
      return;
    }
    const std::string key = is_radius ? "radius" : "length";
    if (!taken_.insert(row.row + "." + key).second) return;
    if (is_radius && row.use.tool != 0) find_comment(row, row.use.tool);
    row.cells.push_back({key, row.by ? std::optional(*row.by->tool_data.diameter / 2) : std::nullopt});
    if (row.by && row.by->tool_data.corner && has(def_, SetupNeeds::corner_radius))
      row.cells.push_back({"corner_radius", row.by->tool_data.corner});
  }

  void add_geometry(SetupUseRow& row) const {
    for (const std::string& axis : control_.axes())
      if (axis == "X" || axis == "Y" || axis == "Z") {
        row.cells.push_back({axis, std::nullopt});
        row.cells.push_back({axis + "_wear", std::nullopt});
      }
  }

  void add_axes(SetupUseRow& row) const {
    const std::vector<std::string>& axes = control_.axes();
    for (std::size_t a = 0; a < axes.size() && a < 3; ++a) row.cells.push_back({axes[a], std::nullopt});
  }

  void find_comment(SetupUseRow& row, std::uint32_t tool) const {
    const auto call = called_.find(tool);
    const std::uint32_t line = call == called_.end() || call->second.origin.file != 0 ? 0 : call->second.origin.line;
    row.by = proposals_.of(tool, line);
    if (!row.by) row.unsure = proposals_.unsure(tool, line);
  }

  void find_not_executed() {
    auto& ranges = found_.not_executed;
    bool open = false;
    for (const auto& [number, text] : lines_) {
      if (!holds_block(text)) continue;
      const bool passed = control_.use().passed(number);
      if (!passed && open) ranges.back().second = number;
      if (!passed && !open) ranges.emplace_back(number, number);
      open = !passed;
    }
  }

  const Control& control_;
  const ControlDef& def_;
  const ProgramLines lines_;
  const ToolProposals proposals_;
  std::map<std::uint32_t, Use> called_;  // the first call of each tool
  std::set<std::string> taken_;          // values of the offset table that are in a row already
  SetupUse found_;
};

}  // namespace

ExecutedBlocks execute_for_use(Session& session, const StopToken& stop) {
  ExecutedBlocks done;
  session.control().watch_use();
  Outlets& outlets = session.outlets();
  outlets.stop = stop;
  outlets.warning = [](const AlarmReport&) {};
  outlets.programmed = [&done](const Action& action) {
    if (const auto* const motion = motion_of(action)) done.moved.take(*motion);
  };
  outlets.alarm = [&done](const AlarmReport& report) {
    const bool fatal = report.alarm.id == AlarmId::endless_program || report.alarm.id == AlarmId::interrupted;
    if (!fatal) ++done.faults;
    return !fatal && done.faults < gives_up_at;
  };
  // the programs of other channels are not available, so the program does not wait for them
  session.control().set_waiting(Control::Waiting::pass);
  (void)session.run();
  return done;
}

SetupUse setup_use(const Control& control, const ControlDef& def, const ExecutedBlocks& done) {
  return UseReader(control, def, done).read();
}

}  // namespace kadr
