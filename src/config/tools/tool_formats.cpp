// Reads LinuxCNC's tool table, and recognises the format of a tools file. Used by config/tools/tool_library; tested by
// tests/config/tool_library_test.cpp.

#include "config/tools/tool_formats.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/vec.h"
#include "config/nearest.h"
#include "texts/tool_formats.h"

namespace kadr {
namespace {

constexpr double assumed_length = 100;  // assumed length of a tool, mm, because a table of offsets does not state the length
constexpr double assumed_edge = 10;     // assumed length of an insert's cutting edge, mm, because the table does not state it

bool ends_with_any(const std::string& path, std::initializer_list<std::string_view> endings) {
  const std::string small = in_small_letters(path);
  return std::any_of(endings.begin(), endings.end(), [&](std::string_view e) { return small.ends_with(e); });
}

std::optional<double> number_after(std::string_view line, char letter) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if ((line[i] & ~0x20) != letter || (i > 0 && line[i - 1] != ' ' && line[i - 1] != '\t')) continue;
    std::string_view rest = line.substr(i + 1);
    if (rest.starts_with('+')) rest.remove_prefix(1);
    double value = 0;
    const auto read = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    if (read.ec == std::errc() && std::isfinite(value)) return value;
  }
  return std::nullopt;
}

/// Derives the kind of a tool from its comment in the table: "6mm ball nose", "drill 118 deg".
ToolKind kind_in_words(std::string_view comment) {
  const std::string words = in_small_letters(comment);
  const auto has_word = [&](std::string_view word) { return words.find(word) != std::string::npos; };
  if (has_word("ball")) return ToolKind::ball;
  if (has_word("drill")) return ToolKind::drill;
  return ToolKind::flat;
}

/// Direction, along x and z, from the nose's centre to the tip. The index is the orientation Q of LinuxCNC's drawing of the tool
/// (rs274/glcanon.py).
constexpr struct { int x, z; } tips_by_q[] = {{0, 0}, {-1, 1}, {-1, -1}, {1, -1}, {1, 1}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}, {0, 0}};

/// Converts the direction of a cutting edge, in degrees from +z towards +x, to its angle from the feed direction, 0 to 360. The feed
/// direction is the direction along z in which the tip points.
double from_feed(double direction, int tip_x, int tip_z) {
  const double turned = tip_x > 0 ? -direction : direction, angle = std::fmod(tip_z > 0 ? turned : 180 - turned, 360);
  return angle < 0 ? angle + 360 : angle;
}

double edge_of(const ToolGeometry& insert) { return std::max(assumed_edge, 3 * insert.corner / std::sin(insert.angle * rad_per_deg)); }

/// Returns the insert of a row. The row must have an orientation Q and the angles I, J of both cutting edges; Q9 is a round insert. Returns
/// nullopt for any other row.
std::optional<ToolGeometry> insert_of_table(std::string_view line) {
  const auto q = number_after(line, 'Q'), front = number_after(line, 'I'), back = number_after(line, 'J');
  if (!q || !front || !back || !(*q >= 1 && *q <= 9) || *q != std::floor(*q)) return std::nullopt;
  ToolGeometry tool;
  tool.kind = ToolKind::turning;
  tool.corner = std::fabs(number_after(line, 'D').value_or(0)) / 2;
  tool.insert.tip_x = tips_by_q[int(*q)].x, tool.insert.tip_z = tips_by_q[int(*q)].z;
  if (*q != 9) {
    const double a = from_feed(*front, tool.insert.tip_x, tool.insert.tip_z), b = from_feed(*back, tool.insert.tip_x, tool.insert.tip_z);
    tool.insert.lead = std::min(a, b);
    tool.angle = std::fabs(a - b);
    if (tool.angle > 180) tool.insert.lead = std::max(a, b), tool.angle = 360 - tool.angle;
    tool.flutes = edge_of(tool);
  }
  complete(tool);
  return tool_fault_message(tool).empty() ? std::optional(tool) : std::nullopt;
}

}  // namespace

ToolFormat tool_format_of(std::string_view text, const std::string& path) {
  if (ends_with_any(path, {".tbl"})) return ToolFormat::linuxcnc;
  if (ends_with_any(path, {".toml"})) return ToolFormat::toml;
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  const bool json = first != std::string_view::npos && text[first] == '{';
  if (!json) return ends_with_any(path, {".json", ".fctb", ".camotics", ".ctbl"}) ? ToolFormat::camotics : ToolFormat::toml;
  const auto holds = [&](std::string_view word) { return text.find(word) != std::string_view::npos; };
  if (ends_with_any(path, {".fctb"}) || holds(".fcstd")) return ToolFormat::freecad;
  return holds("\"data\"") && holds("\"geometry\"") ? ToolFormat::fusion : ToolFormat::camotics;
}

void take_unit(double mm, ToolLibrary& library) {
  if (!library.in_machine_units) return;
  library.in_machine_units = false;
  if (mm == 1) return;
  for (ToolGeometry& tool : library.tools) {
    tool.diameter *= mm, tool.corner *= mm;
    if (tool.kind != ToolKind::turning || tool.insert.lead == std::nullopt) continue;
    tool.flutes = edge_of(tool), tool.length = std::max(tool.length, tool.flutes);
  }
}

/// Reads T, P, D and the comment after `;` from LinuxCNC's tool table. The lengths are in the units of the machine.
tl::expected<ToolLibrary, std::string> tools_of_linuxcnc(std::string_view text, const std::string& file) {
  ToolLibrary library;
  library.in_machine_units = true;
  std::size_t line_number = 0, without = 0;
  while (!text.empty() && library.tools.size() < limits::tools) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    ++line_number;
    const std::size_t semicolon = line.find(';');
    const std::string_view comment = semicolon == std::string_view::npos ? std::string_view() : line.substr(semicolon + 1);
    line = line.substr(0, semicolon);
    const auto number = number_after(line, 'T'), diameter = number_after(line, 'D');
    if (!number) continue;
    if (!(*number >= 0 && *number <= 99'999'999))
      return tl::unexpected(file + ":" + std::to_string(line_number) + ": " + translated(texts::tool_formats::no_tool_number));
    if (auto insert = insert_of_table(line)) {
      insert->number = std::uint32_t(*number);
      insert->name = std::string(comment.substr(0, 80));
      library.tools.push_back(std::move(*insert));
      continue;
    }
    if (!diameter || !(*diameter > 0)) {
      ++without;
      continue;
    }
    ToolGeometry tool;
    tool.number = std::uint32_t(*number);
    tool.name = std::string(comment.substr(0, 80));
    tool.kind = kind_in_words(comment);
    tool.diameter = *diameter;
    tool.angle = tool.kind == ToolKind::drill ? 118 : 0;
    tool.length = tool.flutes = assumed_length;
    if (const std::string fault = tool_fault_message(tool); !fault.empty())
      return tl::unexpected(file + ":" + std::to_string(line_number) + ": " + fault);
    library.tools.push_back(tool);
  }
  if (library.tools.empty()) return tl::unexpected(file + ": " + translated(texts::tool_formats::no_tool_with_diameter));
  library.notes.push_back(file + ": " + translated(texts::tool_formats::diameters_only));
  if (std::any_of(library.tools.begin(), library.tools.end(), [](const ToolGeometry& t) { return t.kind == ToolKind::turning; }))
    library.notes.push_back(file + ": " + translated(texts::tool_formats::turning_tools));
  if (without != 0) library.notes.push_back(file + ": " + translated(texts::tool_formats::without_diameter, without));
  return library;
}

}  // namespace kadr
