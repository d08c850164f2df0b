// Converts the hint of an alarm into a change of the program text. This file is used by view/page/page_json and tested by
// tests/out/quick_fix_test.cpp.

#include "out/text/quick_fix.h"

#include <fmt/core.h>

#include <algorithm>

#include "out/text/source_line.h"
#include "texts/quick_fix.h"

namespace kadr {
namespace {

std::size_t without_trailing_blanks(std::string_view line) {
  const std::size_t last = line.find_last_not_of(" \t\r\n");
  return last == std::string_view::npos ? 0 : last + 1;
}

/// Returns the span of the whole word whose letter is at `begin`. Returns an empty span if the value of the word is not a plain number.
Span whole_word(std::string_view line, std::uint32_t begin) {
  const std::size_t end = std::min(line.find_first_not_of("+-0123456789.", begin + 1), line.size());
  if (end == begin + 1 || (end < line.size() && (line[end] == '[' || line[end] == '#'))) return {begin, begin};
  return {begin, std::uint32_t(end)};
}

/// Extends the span of a word that is to be removed, so that a blank next to the word is removed too.
Span with_a_blank(std::string_view line, Span word) {
  const bool after = word.end < line.size() && line[word.end] == ' ', before = word.begin > 0 && line[word.begin - 1] == ' ';
  if (before && (after || word.end >= without_trailing_blanks(line))) --word.begin;
  else if (after && word.begin == 0) ++word.end;
  return word;
}

}  // namespace

std::optional<QuickFix> quick_fix(const AlarmReport& report, Lang lang) {
  const std::string& line = report.line_text;
  const Span where = report.alarm.where;
  if (line.empty() || where.end > line.size() || where.begin > where.end) return std::nullopt;
  const auto change = [&](Span place, std::string insert, std::string text) {
    return QuickFix{std::move(text), characters_before(line, place.begin) + 1, characters_before(line, place.end) + 1, std::move(insert)};
  };
  const auto at_end = [&](const char* insert) {
    const auto end = std::uint32_t(without_trailing_blanks(line));
    return change({end, end}, insert, translated_in(lang, texts::quick_fix::write_at_end, insert));
  };
  const std::string marked = line.substr(where.begin, where.end - where.begin);
  const auto instead = [&](const std::string& insert) {
    return change(where, insert, translated_in(lang, texts::quick_fix::replace_by, insert));
  };
  const auto instead_of_arc = [&](std::string_view code) -> std::optional<QuickFix> {
    const bool is_arc = marked == "G2" || marked == "G02" || marked == "G3" || marked == "G03";
    // nullopt: the arc code may be in an earlier line, so it cannot be replaced here
    return is_arc ? std::optional(instead(std::string(code))) : std::nullopt;
  };
  const auto row_of_tool = [&](char address, double tool) -> std::optional<QuickFix> {
    const bool is_word = marked.size() > 1 && marked[0] == address && marked.find_first_not_of("0123456789", 1) == std::string::npos;
    return is_word ? std::optional(instead(fmt::format("{}{:.0f}", address, tool))) : std::nullopt;
  };
  switch (report.alarm.id) {
    case AlarmId::look_alike_letter: {
      const std::string latin(report.alarm.args[1].text());
      if (latin.size() != 1) return std::nullopt;
      return change(where, latin, translated_in(lang, texts::quick_fix::replace_by_latin, latin));
    }
    case AlarmId::comment_not_closed: return at_end(")");
    case AlarmId::bracket_not_closed: return at_end("]");
    case AlarmId::word_passed_over:
    case AlarmId::word_unused:
    case AlarmId::address_twice:
      if (const Span word = whole_word(line, where.begin); word.end > word.begin)
        return change(with_a_blank(line, word), "",
                      translated_in(lang, texts::quick_fix::remove_word, line.substr(word.begin, word.end - word.begin)));
      return std::nullopt;
    case AlarmId::point_forgotten: return change({where.end, where.end}, ".", plain_text(texts::quick_fix::write_point, lang));
    case AlarmId::arc_against_neighbours: return instead_of_arc(report.alarm.args[0].text());
    case AlarmId::length_of_other:
    case AlarmId::radius_of_other:
      return row_of_tool(report.alarm.id == AlarmId::length_of_other ? 'H' : 'D', report.alarm.args[1].number());
    default: return std::nullopt;
  }
}

}  // namespace kadr
