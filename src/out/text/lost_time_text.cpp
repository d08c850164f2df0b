// Writes the table of `kadr run --why`: the program lines that lose most time, and the reason. Used by session/planned.

#include "out/text/lost_time_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "out/text/limit_text.h"
#include "out/text/source_line.h"

namespace kadr {
namespace {

constexpr std::size_t widest_block = 48;  // characters of a program line that are printed

struct LostTimeWords {
  const char *heading, *nothing, *all, *times;
  std::array<const char*, 6> columns;
};
constexpr LostTimeWords english_lost_time = {
    "lost time       what the axes need beyond the time by feed and rapid rate alone, s; the worst lines",
    "nothing: each motion takes its time by feed and rapid rate",
    "lost in all lines",
    "times",
    {"line", "time", "by feed", "lost", "by", "block"}};
constexpr LostTimeWords russian_lost_time = {"потери времени  сверх времени по подачам и быстрым ходам станка, с; худшие строки",
                                             "нет: каждое движение идёт по подаче или быстрому ходу",
                                             "потери во всех строках",
                                             "раз",
                                             {"строка", "время", "по подаче", "потеря", "причина", "кадр"}};

using LostTimeCells = std::array<std::string, 6>;

LostTimeCells cells_of(const LostTimeRow& row, const LostTimeWords& words, const std::vector<std::string>& axes, Lang lang) {
  const LostTime::Place& place = row.place;
  std::string line = row.file.empty() ? "" : row.file + ":";
  line += fmt::format("{}", place.line);
  if (place.times > 1) line += fmt::format(" ({} {})", place.times, words.times);
  const std::string by = fmt::format("{} {:.0f} %", limit_text(place.by, place.rapid, axes, lang), 100 * place.by_part);
  const auto seconds = [](double s) { return fmt::format("{:.3f}", s); };
  return {line, seconds(place.seconds), seconds(place.at_feed), seconds(place.lost()), by, shortened_line(row.block, widest_block)};
}

}  // namespace

std::string lost_time_text(const std::vector<LostTimeRow>& rows, double all, const std::vector<std::string>& axes, Lang lang) {
  constexpr std::string_view indent = "                ", gap = "  ";
  const LostTimeWords& words = lang == Lang::ru ? russian_lost_time : english_lost_time;
  std::vector<LostTimeCells> table(1);
  std::copy(words.columns.begin(), words.columns.end(), table[0].begin());
  for (const LostTimeRow& row : rows) table.push_back(cells_of(row, words, axes, lang));
  const auto width = [](const std::string& text) { return characters_before(text, text.size()); };
  std::array<std::size_t, 6> widths{};
  for (const LostTimeCells& cells : table)
    for (std::size_t i = 0; i < cells.size(); ++i) widths[i] = std::max<std::size_t>(widths[i], width(cells[i]));
  std::string text = std::string(words.heading) + "\n";
  if (rows.empty()) return text + std::string(indent) + words.nothing + "\n";
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
  return text + fmt::format("{}{}: {:.3f}\n", indent, words.all, all);
}

}  // namespace kadr
