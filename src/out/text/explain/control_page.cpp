// Creates the page docs/controls/ID.md, which shows all rows of a control's file as tables, in both languages.

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

#include "out/text/explain/code_page.h"
#include "out/text/explain/name_text.h"
#include "out/text/explain/variable_text.h"
#include "texts/explain_control.h"

namespace kadr {
namespace {

namespace heading_ids = texts::explain_control;

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

std::string cells(const Text& text) { return fmt::format("{} | {}", escaped(text.en), escaped(text.ru)); }

/// Returns the English and the Russian heading for two columns of a table, e.g. "meaning | значение".
std::string headings(PlainText text) { return fmt::format("{} | {}", plain_text(text, Lang::en), plain_text(text, Lang::ru)); }

/// Returns the heading row of a Markdown table and the separator line below it, e.g. "| a | b |", "|---|---|".
std::string table_head(const std::string& columns) {
  const auto bars = static_cast<std::size_t>(std::count(columns.begin(), columns.end(), '|'));
  std::string rule = "|";
  for (std::size_t i = 1; i < bars; ++i) rule += "---|";
  return columns + "\n" + rule + "\n";
}

void address_rows(const ControlDef& def, std::string& page) {
  page += "\n## Addresses\n\n" + table_head(fmt::format("| address | format | {} | source |", headings(heading_ids::meaning)));
  for (const AddressRow& row : def.addresses)
    if (row.function != Function::count)
      page +=
          fmt::format("| {} | {} | {} | {} |\n", address_written(row.letter), format_of(def, row), cells(row.text), escaped(row.manual));
}

void code_rows(const ControlDef& def, char letter, std::string& page) {
  // If Kadr supports all codes of the control, the column that states which codes are supported is omitted.
  const bool all_work = std::all_of(def.codes.begin(), def.codes.end(), [](const CodeRow& row) { return row.works && !row.in_part; });
  page += fmt::format("\n## {} codes\n\n", letter);
  page += table_head(
      fmt::format("| code | group | lasts | words |{} {} | source |", all_work ? "" : " works |", headings(heading_ids::meaning)));
  for (const CodeRow& row : def.codes) {
    if (row.letter != letter) continue;
    const char* const works = all_work ? "" : !row.works ? " not yet |" : row.in_part ? " in part |" : " yes |";
    page += fmt::format("| {}{} | {} | {} | {} |{} {} | {} |\n", row.code, initial_mark(def, row), def.groups[row.group].name,
                        row.modal ? "modal" : "block", words_of(row, Lang::en), works, cells(row.text), escaped(row.manual));
  }
}

void cycle_rows(const ControlDef& def, std::string& page) {
  bool bodies = false;
  for (const CycleRow& row : def.cycles) {
    const std::string& printed = row.body.empty() ? row.printed : row.body;
    if (printed.empty()) continue;
    if (!bodies) page += "\n## Cycles\n\n" + table_head(fmt::format("| cycle | {} | body |", headings(heading_ids::meaning)));
    bodies = true;
    std::string body;
    for (const char c : printed) body += c == '\n' ? std::string("` · `") : std::string(1, c);
    page += fmt::format("| {} | {} | `{}` |\n", row.name, cells(row.text), body.substr(0, body.size() - std::string("` · `").size()));
  }
}

void variable_rows(const ControlDef& def, std::string& page) {
  if (def.variables.empty()) return;
  const bool symbols = std::any_of(def.variables.begin(), def.variables.end(), [](const VariableRow& row) { return !row.symbol.empty(); });
  page += "\n## System variables\n\n";
  page +=
      table_head(fmt::format("| numbers |{} {} | source |", symbols ? " symbol | access | works |" : "", headings(heading_ids::meaning)));
  for (const VariableRow& row : def.variables) {
    std::string more;
    if (symbols)
      more = fmt::format(" {} | {} | {} |", symbol_of(row), !row.write ? "R" : !row.read ? "W" : "R/W", row.works ? "yes" : "not yet");
    page += fmt::format("| {} |{} {} | {} |\n", numbers_of(def, row, Lang::en), more, cells(row.text), escaped(row.manual));
  }
}

void parameter_rows(const ControlDef& def, std::string& page) {
  if (def.parameters.empty()) return;
  constexpr const char* scopes[] = {"control", "channel", "axis", "spindle"};
  constexpr const char* types[] = {"bits", "whole", "real", "text"};
  const bool by_program = def.machine_axes();  // true: programs set parameters with G10 L52
  page += by_program
              ? "\n## Parameters\n\nNot every one is in the manual of programming: those that its chapters name. `G10 L52` may write all "
                "but those that need a restart. \"no effect\": kept, read and written by programs, but nothing follows from it in Kadr.\n\n"
              : "\n## Parameters\n\nThe set-up states them. \"no effect\": nothing follows from it in Kadr.\n\n";
  page += table_head(
      fmt::format("| number | of | kind | bits | initial | written by G10 | works | {} | source |", headings(heading_ids::meaning)));
  for (const ParameterRow& row : def.parameters) {
    std::string bits;
    for (std::size_t i = 0; i < row.bits.size(); ++i)
      if (!row.bits[i].empty()) bits += fmt::format("{}{}{}", bits.empty() ? "" : " ", i < 8 ? fmt::format("#{} ", i) : "", row.bits[i]);
    const bool writable = by_program && row.when == ParameterClass::run_time;
    page +=
        fmt::format("| {}{} | {} | {} | {} | {} | {} | {} | {} | {} |\n", row.number >= 0 ? "N" : "", row.name,
                    scopes[static_cast<std::size_t>(row.scope)], types[static_cast<std::size_t>(row.type)], bits, number_text(row.initial),
                    writable ? "yes" : "no", row.used ? "yes" : "no effect", cells(row.text), escaped(row.manual));
  }
}

/// Appends the alarms for which the control's file has rows. They are sorted by number; alarms without a number come last.
void alarm_rows(const ControlDef& def, const AlarmTexts& texts, std::string& page) {
  if (def.alarms.empty()) return;
  std::vector<AlarmId> ids;
  for (const auto& [id, row] : def.alarms) ids.push_back(id);
  const auto rank = [&](AlarmId id) { return texts.number(id).empty() ? 1e9 : std::atof(texts.number(id).c_str()); };
  std::stable_sort(ids.begin(), ids.end(), [&](AlarmId a, AlarmId b) { return rank(a) < rank(b); });
  page +=
      "\n## Alarms\n\nThose that have a number or words of the control's own, and those that only some controls give; `{0}` stands for the "
      "figure of the case.\n\n";
  page += table_head(fmt::format("| number | alarm | {} | {} |", headings(heading_ids::alarm_text), headings(heading_ids::alarm_hint)));
  for (const AlarmId id : ids) {
    const Text text = {texts.pattern(id, Lang::en), texts.pattern(id, Lang::ru)};
    const Text hint = {texts.hint_pattern(id, Lang::en), texts.hint_pattern(id, Lang::ru)};
    page += fmt::format("| {} | `{}` | {} | {} |\n", texts.number(id), name_of(id), cells(text), cells(hint));
  }
}

}  // namespace

std::string control_page(const ControlDef& def, const AlarmTexts& texts) {
  std::string page = fmt::format(
      "<!-- Made by `kadr explain {0} --markdown`: do not edit, see dev/docs. -->\n# {1}\n\n{2}\n\nControl id: `{0}`. Rules: `{3}`.\n",
      def.id, def.name.en, def.name.ru, def.spec);
  if (!def.descriptor.empty()) page += fmt::format("\nFormat: `{}`\n", def.descriptor);
  page += "\n`*` is in force at power-on.\n";
  address_rows(def, page);
  code_rows(def, 'G', page);
  code_rows(def, 'M', page);
  cycle_rows(def, page);
  name_rows(def, page);
  variable_rows(def, page);
  parameter_rows(def, page);
  alarm_rows(def, texts, page);
  return page;
}

}  // namespace kadr
