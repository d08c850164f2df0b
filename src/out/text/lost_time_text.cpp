// Formats the table of `kadr run --why`: the program lines that lose the most time, with the reasons. This file is used by session/planned.

#include "out/text/lost_time_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "out/text/limit_text.h"
#include "out/text/source_line.h"
#include "texts/lost_time.h"

namespace kadr {
namespace {

constexpr std::size_t widest_block = 48;  // greatest number of characters of a program line that are printed

constexpr std::array<PlainText, 6> lost_time_columns = {texts::lost_time::column_line,    texts::lost_time::column_time,
                                                        texts::lost_time::column_by_feed, texts::lost_time::column_lost,
                                                        texts::lost_time::column_reason,  texts::lost_time::column_block};

using LostTimeCells = std::array<std::string, 6>;

LostTimeCells cells_of(const LostTimeRow& row, const std::vector<std::string>& axes, Lang lang) {
  const LostTime::Place& place = row.place;
  std::string line = row.file.empty() ? "" : row.file + ":";
  line += fmt::format("{}", place.line);
  if (place.times > 1) line = translated_in(lang, texts::lost_time::line_several_times, line, place.times);
  const std::string by = fmt::format("{} {:.0f} %", limit_text(place.by, place.rapid, axes, lang), 100 * place.by_part);
  const auto seconds = [](double s) { return fmt::format("{:.3f}", s); };
  return {line, seconds(place.seconds), seconds(place.at_feed), seconds(place.lost()), by, shortened_line(row.block, widest_block)};
}

}  // namespace

std::string lost_time_text(const std::vector<LostTimeRow>& rows, double all, const std::vector<std::string>& axes, Lang lang) {
  constexpr std::string_view indent = "                ", gap = "  ";
  std::vector<LostTimeCells> table(1);
  for (std::size_t i = 0; i < lost_time_columns.size(); ++i) table[0][i] = plain_text(lost_time_columns[i], lang);
  for (const LostTimeRow& row : rows) table.push_back(cells_of(row, axes, lang));
  const auto width = [](const std::string& text) { return characters_before(text, text.size()); };
  std::array<std::size_t, 6> widths{};
  for (const LostTimeCells& cells : table)
    for (std::size_t i = 0; i < cells.size(); ++i) widths[i] = std::max<std::size_t>(widths[i], width(cells[i]));
  std::string text = translated_in(lang, texts::lost_time::heading) + "\n";
  if (rows.empty()) return text + std::string(indent) + plain_text(texts::lost_time::nothing, lang) + "\n";
  for (const LostTimeCells& cells : table) {
    text += indent;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string pad(widths[i] - width(cells[i]), ' ');
      const bool number = i >= 1 && i <= 3, last = i + 1 == cells.size();
      text += number ? pad + cells[i] : cells[i] + (last ? "" : pad);
      if (!last) text += gap;
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text + std::string(indent) + translated_in(lang, texts::lost_time::all_lines, all) + "\n";
}

}  // namespace kadr
