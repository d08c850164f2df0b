// LinuxCNC's tool table, and which form a file has. For config/tool_library; tested by tests/config/tool_formats_test.cpp.

#include "config/tool_formats.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "config/nearest.h"
#include "config/told.h"

namespace kadr {
namespace {

constexpr double assumed_length = 100;  // mm: a table of offsets says nothing of it

bool ends_with_any(const std::string& path, std::initializer_list<std::string_view> endings) {
  const std::string small = in_small_letters(path);
  return std::any_of(endings.begin(), endings.end(), [&](std::string_view e) { return small.ends_with(e); });
}

std::optional<double> number_behind(std::string_view line, char letter) {
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

/// What the comment of a table says of the form: "6mm ball nose", "drill 118 deg".
ToolKind kind_in_words(std::string_view comment) {
  const std::string words = in_small_letters(comment);
  const auto says = [&](std::string_view word) { return words.find(word) != std::string::npos; };
  if (says("ball")) return ToolKind::ball;
  if (says("drill")) return ToolKind::drill;
  return ToolKind::flat;
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

/// T, P, D and what stands behind ; (LinuxCNC, tool table). Lengths in mm: the table of a metric machine.
tl::expected<ToolLibrary, std::string> tools_of_linuxcnc(std::string_view text, const std::string& file) {
  ToolLibrary library;
  std::size_t line_number = 0, without = 0;
  while (!text.empty() && library.tools.size() < limits::tools) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    ++line_number;
    const std::size_t semicolon = line.find(';');
    const std::string_view comment = semicolon == std::string_view::npos ? std::string_view() : line.substr(semicolon + 1);
    line = line.substr(0, semicolon);
    const auto number = number_behind(line, 'T'), diameter = number_behind(line, 'D');
    if (!number) continue;
    if (!(*number >= 0 && *number <= 99'999'999))
      return tl::unexpected(file + ":" + std::to_string(line_number) + told(": no tool number", ": не номер инструмента"));
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
    if (const std::string fault = told_fault(tool); !fault.empty())
      return tl::unexpected(file + ":" + std::to_string(line_number) + ": " + fault);
    library.tools.push_back(tool);
  }
  if (library.tools.empty())
    return tl::unexpected(file + ": " + told("no tool with a diameter (T… P… D…)", "ни одного инструмента с диаметром (T… P… D…)"));
  library.notes.push_back(
      file + ": " +
      told("a tool table has diameters only, taken for mm: tools are flat unless their comment says ball or drill (118°), "
           "and cut over 100 mm",
           "в таблице инструментов только диаметры, приняты за мм: фрезы считаются концевыми, если в комментарии нет "
           "ball или drill (118°), и режут на длине 100 мм"));
  if (without != 0)
    library.notes.push_back(file + ": " +
                            told(std::to_string(without) + " tools without a diameter left out",
                                 "пропущено инструментов без диаметра: " + std::to_string(without)));
  return library;
}

}  // namespace kadr
