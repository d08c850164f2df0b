// Tool table, datum tables, tables of points (spec/heidenhain 2.5, 11.2, 12.7). Used by control/heidenhain.

#include <cmath>

#include "config/read_file.h"
#include "control/heidenhain/heidenhain.h"
#include "control/heidenhain/text_table.h"

namespace kadr::heidenhain {

/// Reads the tool table TOOL.T in the root of the program memory. A tool that the set-up has too is that of the set-up.
void Heidenhain::read_tool_table(BlockContext& m) {
  const RunLimits& limits = m.program().limits();
  constexpr std::size_t most_bytes = 4U << 20U;
  constexpr double most_tools = 32'767;
  if (limits.files.empty()) return;
  for (const char* const name : {"tool.t", "TOOL.T"}) {
    const auto text = read_file(limits.files + "/" + name, most_bytes, limits.door);
    if (!text) continue;
    const TextTable table = read_text_table(*text);
    for (const auto& row : table.rows) {
      const auto number = TextTable::number(row, "T");
      if (!number || !(*number >= 0 && *number <= most_tools)) continue;
      const auto tool = static_cast<std::uint32_t>(*number);
      if (const auto label = row.find("NAME"); label != row.end()) names_.emplace(label->second, tool);
      if (table_.contains(tool)) continue;
      if (m.tables.offsets.size() <= tool) m.tables.offsets.resize(tool + 1);
      ToolOffset& to = m.tables.offsets[tool];
      const auto value = [&](const char* column) { return TextTable::number(row, column).value_or(0) * table.unit; };
      to.length = value("L");
      to.length_wear = value("DL");
      to.radius = value("R");
      to.radius_wear = value("DR");
      to.corner = value("R2");
      to.corner_wear = value("DR2");
      if (const auto teeth = TextTable::number(row, "CUT")) teeth_[tool] = *teeth;
      table_.insert(tool);
    }
    return;
  }
}

/// Puts a row of the datum table in force: each axis that the table has gets its shift.
///   alarms  file_missing; variable_not_set: the table has no such row
Status Heidenhain::take_datum_row(Emitter& m, double row, Span where) {
  const auto text = read_table(m, memory.datum_table.empty() ? "NULLTAB.D" : memory.datum_table, where);
  if (!text) return fail(text.error());
  const TextTable table = read_text_table(*text);
  for (const auto& each : table.rows) {
    auto number = TextTable::number(each, "NR");
    if (!number) number = TextTable::number(each, "D");
    if (!number || std::lround(*number) != std::lround(row)) continue;
    for (std::size_t a = 0; a < m.axis_count; ++a)
      if (const auto value = TextTable::number(each, m.axis_names[a]))
        memory.shift[a] = *value * ((m.def.rotary >> a & 1U) != 0 ? 1 : table.unit);
    return set_frame(m);
  }
  const std::string name = "#" + std::to_string(std::lround(row));
  return fail(alarm(AlarmId::variable_not_set, where, std::string_view(name)));
}

/// SEL PATTERN: the points of a table become the pattern of CYCL CALL PAT. Points that FADE hides are left out.
Status Heidenhain::select_points(Emitter& m, const std::string& path, Span where) {
  const auto text = read_table(m, path, where);
  if (!text) return fail(text.error());
  const TextTable table = read_text_table(*text);
  memory.pattern.clear();
  for (const auto& row : table.rows) {
    if (const auto hidden = row.find("FADE"); hidden != row.end() && (hidden->second == "Y" || hidden->second == "1")) continue;
    Axes point{};
    for (const std::size_t a : {0U, 1U, 2U}) point[a] = TextTable::number(row, m.axis_names[a]).value_or(0) * table.unit;
    memory.pattern.push_back(point);
  }
  return {};
}

}  // namespace kadr::heidenhain
