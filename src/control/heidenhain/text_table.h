#pragma once
// TextTable: a table of the control as text: TOOL.T, datum tables .D, tables of points .PNT (spec/heidenhain 2.5, 11.2, 12.7). Its first
// line is BEGIN NAME MM or INCH, the second has the names of the columns, whose places fix the columns; it ends with [END]. Only
// src/control/heidenhain includes this file.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kadr::heidenhain {

struct TextTable {
  double unit = 1;                                       // mm; 25.4 if the table is in inches
  std::vector<std::map<std::string, std::string>> rows;  // by the name of the column, without blanks around; empty cells are missing

  /// Returns the number in a cell; nullopt if the cell is empty or has no number.
  static std::optional<double> number(const std::map<std::string, std::string>& row, const std::string& column);
};

TextTable read_text_table(std::string_view text);

}  // namespace kadr::heidenhain
