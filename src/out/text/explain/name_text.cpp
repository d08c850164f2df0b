// Explains names of statements, words and cycles. Used by out/text/explain/code_page, control_page and line_words; tested by
// tests/out/name_text_test.cpp.

#include "out/text/explain/name_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/ascii.h"
#include "lang/named/named_parser.h"
#include "out/text/in_language.h"
#include "texts/explain_code.h"
#include "texts/explain_control.h"

namespace kadr {
namespace {

std::string call_of(const NameRow& row) {
  if (row.parameters.empty()) return row.name;
  std::string text;
  for (const NameParameter& p : row.parameters) text += (text.empty() ? "" : ", ") + p.name;
  return fmt::format("{}({})", row.name, text);
}

/// Finds the arguments of a call whose parenthesis opens at `open`, and gives each one that is written to `take`.
void each_argument(std::string_view line, std::size_t open, std::size_t end, const NameRow& row,
                   const std::function<void(const StatementPart&)>& take) {
  std::size_t begin = open + 1, n = 0;
  int depth = 1;
  bool quoted = false;
  for (std::size_t i = begin; i < end && depth > 0; ++i) {
    const char c = line[i];
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == '(' || c == '[') ++depth;
    if (c == ')' || c == ']') --depth;
    if (depth > 1 || (depth == 1 && c != ',')) continue;
    const std::size_t first = line.find_first_not_of(' ', begin);
    if (n < row.parameters.size() && first < i)
      take({{std::uint32_t(first), std::uint32_t(i)}, row.parameters[n].name, &row, &row.parameters[n]});
    begin = i + 1;
    ++n;
  }
}

}  // namespace

std::optional<std::string> explain_name(const ControlDef& def, std::string_view name, Lang lang) {
  const NameRow* const row = named_row(def, name);
  if (row == nullptr) return std::nullopt;
  std::string text = fmt::format("{} {}: {}\n", def.id, row->name, in_language(row->text, lang));
  if (!row->parameters.empty()) text += fmt::format("  {}\n", call_of(*row));
  std::size_t n = 0, widest = 0;
  for (const NameParameter& p : row->parameters) widest = std::max(widest, p.name.size());
  for (const NameParameter& p : row->parameters)
    text += fmt::format("    {:>2}  {:<{}}  {}\n", ++n, p.name, widest, in_language(p.text, lang));
  if (!row->works) text += fmt::format("  {}\n", plain_text(texts::explain_code::not_executed, lang));
  if (!row->manual.empty()) text += fmt::format("  {}\n", translated_in(lang, texts::explain_code::source, def.spec, row->manual));
  return text;
}

void each_part(const ControlDef& def, std::string_view line, Span statement, const std::function<void(const StatementPart&)>& take) {
  const std::size_t end = std::min<std::size_t>(statement.end, line.size());
  bool quoted = false;
  for (std::size_t i = statement.begin; i < end;) {
    if (line[i] == '"') quoted = !quoted;
    const bool system = i > 0 && line[i - 1] == '$';
    if (quoted || !begins_name(line[i])) {
      ++i;
      continue;
    }
    std::size_t last = i + 1;
    const bool letter_word = line[i] != '_' && (last >= end || !begins_name(line[last]));
    while (last < end && (letter_word ? is_digit(line[last]) : continues_name(line[last]))) ++last;
    const Span where{std::uint32_t(i), std::uint32_t(last)};
    const std::string_view text = line.substr(i, last - i);
    const char letter = to_upper(text[0]);
    if (!letter_word) {
      const NameRow* const row = system ? nullptr : named_row(def, text);
      if (row != nullptr) take({where, row->name, row});
      const std::size_t open = line.find_first_not_of(' ', last);
      if (row != nullptr && !row->parameters.empty() && open < end && line[open] == '(') each_argument(line, open, end, *row, take);
    } else if (letter == 'G' || letter == 'M') {
      take({where, std::string(1, letter) + std::string(text.substr(1))});
    } else {
      take({where, std::string(1, letter)});
    }
    i = last;
  }
}

void name_rows(const ControlDef& def, std::string& page) {
  const std::vector<NameRow>& rows = named_rows(def);
  if (rows.empty()) return;
  const auto heads = [](PlainText text) { return fmt::format("{} | {}", plain_text(text, Lang::en), plain_text(text, Lang::ru)); };
  page += fmt::format("\n## Names\n\n| name | works | {} | source |\n|---|---|---|---|---|\n", heads(texts::explain_control::meaning));
  for (const NameRow& row : rows)
    page += fmt::format("| {} | {} | {} | {} | {} |\n", call_of(row), row.works ? "yes" : "not yet", row.text.en, row.text.ru, row.manual);
  page +=
      fmt::format("\n### Parameters of cycles\n\n| cycles | parameter | {} |\n|---|---|---|---|\n", heads(texts::explain_control::meaning));
  // One row for each meaning: parameters of several cycles with the same meaning stand once.
  std::vector<std::pair<const NameParameter*, std::string>> all;
  for (const NameRow& row : rows)
    for (const NameParameter& p : row.parameters) {
      const auto same = std::find_if(all.begin(), all.end(),
                                     [&](const auto& one) { return one.first->name == p.name && one.first->text.en == p.text.en; });
      if (same == all.end()) all.emplace_back(&p, row.name);
      else same->second += ", " + row.name;
    }
  for (const auto& [p, cycles] : all) page += fmt::format("| {} | {} | {} | {} |\n", cycles, p->name, p->text.en, p->text.ru);
}

}  // namespace kadr
