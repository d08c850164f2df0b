// Reads and writes LinuxCNC's tool table file (spec/linuxcnc 9; tooldata_read_entry). Used by control/linuxcnc/dialect.

#include "control/linuxcnc/tools.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

#include "base/ascii.h"

namespace kadr::linuxcnc {
namespace {

constexpr std::size_t max_tools = 1000;

/// Returns the number in the text of a word; nullopt if the text is not a number.
std::optional<double> number_in(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
  return value;
}

struct Entry {
  int number = -1;
  bool has_pocket = false;
  Tool tool;
};

bool take_word(Entry& entry, char letter, double value) {
  if (const std::size_t axis = axis_letters.find(letter); axis != std::string_view::npos) {
    entry.tool.offset[axis] = value;
    return true;
  }
  switch (letter) {
    case 'T': entry.number = static_cast<int>(value); return true;
    case 'P': entry.tool.pocket = static_cast<int>(value); return entry.has_pocket = true;
    case 'D': entry.tool.diameter = value; return true;
    case 'I': entry.tool.front = value; return true;
    case 'J': entry.tool.back = value; return true;
    case 'Q': entry.tool.orientation = value; return true;
    default: return false;
  }
}

std::optional<Entry> entry_of(std::string_view line) {
  Entry entry;
  if (const std::size_t semicolon = line.find(';'); semicolon != std::string_view::npos) {
    entry.tool.remark = line.substr(semicolon + 1);
    while (entry.tool.remark.ends_with('\r')) entry.tool.remark.pop_back();
    line = line.substr(0, semicolon);
  }
  for (std::size_t at = 0; at < line.size();) {
    at = line.find_first_not_of(" \t\r", at);
    if (at == std::string_view::npos) break;
    const std::size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
    const auto value = number_in(std::string(line.substr(at + 1, end - at - 1)));
    if (!value || std::fabs(*value) > 1e9 || !take_word(entry, to_upper(line[at]), *value)) return std::nullopt;
    at = end;
  }
  if (entry.number < 0 || !entry.has_pocket) return std::nullopt;
  return entry;
}

void scale_lengths(Tool& tool, double by) {
  for (std::size_t a = 0; a < axes_of_tables; ++a)
    if (!is_rotary_place(a)) tool.offset[a] *= by;
  tool.diameter *= by;
}

std::string line_of_tool(int number, const Tool& tool) {
  std::string line = fmt::format("T{} P{}", number, tool.pocket);
  const auto word = [&](char letter, double value) {
    if (value != 0) line += fmt::format(" {}{:+f}", letter, value);
  };
  if (tool.diameter != 0) line += fmt::format(" D{:f}", tool.diameter);
  for (std::size_t a = 0; a < axes_of_tables; ++a) word(axis_letters[a], tool.offset[a]);
  word('I', tool.front);
  word('J', tool.back);
  if (tool.orientation != 0) line += fmt::format(" Q{:.0f}", tool.orientation);
  return line + " ;" + tool.remark + "\n";
}

}  // namespace

std::string tools_text(const std::map<int, Tool>& tools, double unit) {
  std::string text;
  for (const auto& [number, tool] : tools) {
    Tool written = tool;
    scale_lengths(written, 1 / unit);
    text += line_of_tool(number, written);
  }
  return text;
}

std::map<int, Tool> read_tools(std::string_view text, double unit) {
  std::map<int, Tool> tools;
  for (std::size_t at = 0; at < text.size() && tools.size() < max_tools;) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (auto entry = entry_of(text.substr(at, end - at))) {
      scale_lengths(entry->tool, unit);
      tools.insert_or_assign(entry->number, entry->tool);
    }
    at = end + 1;
  }
  return tools;
}

}  // namespace kadr::linuxcnc
