// Reads tables of the control. Used by control/heidenhain.

#include "control/heidenhain/text_table.h"

#include <algorithm>
#include <cstdlib>

namespace kadr::heidenhain {
namespace {

struct Column {
  std::string name;
  std::size_t begin = 0;
};

std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return static_cast<unsigned char>(c) <= ' '; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::vector<Column> columns_of(std::string_view line) {
  std::vector<Column> all;
  for (std::size_t at = 0; at < line.size();) {
    while (at < line.size() && static_cast<unsigned char>(line[at]) <= ' ') ++at;
    const std::size_t begin = at;
    while (at < line.size() && static_cast<unsigned char>(line[at]) > ' ') ++at;
    if (at > begin) all.push_back({std::string(line.substr(begin, at - begin)), begin});
  }
  return all;
}

}  // namespace

std::optional<double> TextTable::number(const std::map<std::string, std::string>& row, const std::string& column) {
  const auto cell = row.find(column);
  if (cell == row.end()) return std::nullopt;
  std::string digits = cell->second;
  std::replace(digits.begin(), digits.end(), ',', '.');
  char* end = nullptr;
  const double value = std::strtod(digits.c_str(), &end);
  return end == digits.c_str() ? std::nullopt : std::optional(value);
}

TextTable read_text_table(std::string_view text) {
  TextTable table;
  std::vector<Column> columns;
  constexpr std::size_t most_rows = 100'000;
  while (!text.empty() && table.rows.size() < most_rows) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (trimmed(line).empty()) continue;
    if (trimmed(line).starts_with("BEGIN ")) {
      if (trimmed(line).ends_with("INCH")) table.unit = 25.4;
      continue;
    }
    if (trimmed(line).starts_with("[END]")) break;
    if (columns.empty()) {
      columns = columns_of(line);
      continue;
    }
    auto& row = table.rows.emplace_back();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      // The first column begins at the edge of the table, whatever stands before its name.
      const std::size_t begin = i == 0 ? 0 : columns[i].begin;
      if (begin >= line.size()) break;
      const std::size_t next = i + 1 < columns.size() ? columns[i + 1].begin : line.size();
      if (const std::string_view cell = trimmed(line.substr(begin, next - begin)); !cell.empty()) row[columns[i].name] = std::string(cell);
    }
  }
  return table;
}

}  // namespace kadr::heidenhain
