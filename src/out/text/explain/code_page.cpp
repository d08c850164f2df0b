// Describes the table rows of a control for people: one row (kadr explain), or all rows as the page docs/controls/ID.md. This file is used
// by cli/explain and out/text/explain/control_page, and tested by tests/out/code_page_test.cpp.

#include "out/text/explain/code_page.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/ascii.h"
#include "config/control/control_file.h"
#include "out/text/explain/asked_code.h"
#include "out/text/explain/cycle_text.h"
#include "out/text/explain/name_text.h"
#include "out/text/explain/parameter_text.h"
#include "out/text/explain/variable_text.h"
#include "out/text/explain/word_text.h"
#include "out/text/in_language.h"
#include "texts/explain_code.h"

namespace kadr {
namespace {

std::string letters_of(std::uint64_t bits, std::string text = {}) {
  for (int i = 0; i <= comma_vector - 'A'; ++i)
    if ((bits >> i & 1u) != 0) text += fmt::format("{}{}", text.empty() ? "" : " ", address_written(static_cast<char>('A' + i)));
  return text;
}

/// True if the control is delivered with Kadr. Then the text does not mention which other control's file the control extends.
bool is_built_in(const ControlDef& def) {
  const std::vector<std::string> all = built_in_controls();
  return std::find(all.begin(), all.end(), def.id) != all.end();
}

const char* axes_of(const CodeRow& row, Lang lang) { return row.takes_all_axes ? plain_text(texts::explain_code::axes, lang) : ""; }

}  // namespace

std::string words_of(const CodeRow& row, Lang lang) { return letters_of(row.takes, axes_of(row, lang)); }

std::string initial_mark(const ControlDef& def, const CodeRow& row) {
  if (row.group == 0 || def.groups[row.group].power_on < 0) return {};
  return def.codes[static_cast<std::size_t>(def.groups[row.group].power_on)].code == row.code ? "*" : "";
}

/// Returns the format of an address in the notation of the manual: "+043", "02", "free".
std::string format_of(const ControlDef& def, const AddressRow& row) {
  const WordFormat& w = def.grammar.word(row.letter);
  if (w.whole_digits == 0) return w.sign ? "+free" : "free";
  std::string text = w.sign ? "+" : "";
  if (w.drop_zeros) text += '0';
  text += std::to_string(w.whole_digits);
  if (w.fraction_digits != 0) text += std::to_string(w.fraction_digits);
  if (w.point) text += ", point";
  return text;
}

namespace {

/// Returns the section of the manual from which a row comes. Returns an empty text if the row comes from the control that this control
/// extends, since that control has its own manual.
std::string source_text(const ControlDef& def, const std::string& section, Lang lang) {
  return section.empty() ? std::string() : fmt::format("  {}\n", translated_in(lang, texts::explain_code::source, def.spec, section));
}

std::string code_text(const ControlDef& def, const CodeRow& row, Lang lang) {
  namespace ids = texts::explain_code;
  std::string text = fmt::format("{} {}: {}\n", def.id, row.code, in_language(row.text, lang));
  const GroupRow& group = def.groups[row.group];
  if (row.group != 0) text += fmt::format("  {}\n", translated_in(lang, ids::group, group.name, in_language(group.text, lang)));
  text += fmt::format("  {}\n", plain_text(row.modal ? ids::lasts_until_replaced : ids::lasts_one_block, lang));
  if (!initial_mark(def, row).empty()) text += fmt::format("  {}\n", plain_text(ids::in_force_at_power_on, lang));
  if (const std::string words = letters_of(row.takes | number_words(def, row), axes_of(row, lang)); !words.empty())
    text += fmt::format("  {}\n", translated_in(lang, ids::words, words)) + words_text(def, row, lang);
  if (row.needs != 0) text += fmt::format("  {}\n", translated_in(lang, ids::must_have, letters_of(row.needs)));
  text += steps_text(def, row, lang);
  if (!row.works) text += fmt::format("  {}\n", plain_text(ids::not_executed, lang));
  return text + source_text(def, row.manual, lang);
}

std::string address_text(const ControlDef& def, const AddressRow& row, Lang lang) {
  std::string text = fmt::format("{} {}: {}\n", def.id, address_written(row.letter), in_language(row.text, lang));
  text += fmt::format("  {}\n", translated_in(lang, texts::explain_code::format, format_of(def, row)));
  if (row.unit == WordUnit::length && def.grammar.word(row.letter).implied)
    text += fmt::format("  {}\n", plain_text(texts::explain_code::unit_without_point, lang));
  return text + source_text(def, row.manual, lang);
}

std::string cycle_text(const ControlDef& def, const CycleRow& row, Lang lang) {
  std::string text = fmt::format("{} {}: {}\n", def.id, row.name, in_language(row.text, lang));
  std::string_view body = row.body.empty() ? row.printed : row.body;
  while (!body.empty()) {
    const std::size_t end = body.find('\n');
    text += fmt::format("  {}\n", body.substr(0, end));
    body.remove_prefix(end + 1);
  }
  text += steps_text(def, row, lang);
  if (row.needs != 0) text += fmt::format("  {}\n", translated_in(lang, texts::explain_code::needs, letters_of(row.needs)));
  return text + source_text(def, row.manual, lang);
}

/// Returns the text of the alarm. If the control has its own text, which the operator reads on its screen, both languages are returned.
std::string alarm_text_of(const ControlDef& def, const AlarmTexts& texts, AlarmId id, Lang lang) {
  const std::string& number = texts.number(id);
  std::string text = fmt::format("{}{}: {}\n", number.empty() ? "" : number + " ", name_of(id), texts.pattern(id, lang));
  if (def.alarms.contains(id)) text += fmt::format("  {}\n", texts.pattern(id, lang == Lang::ru ? Lang::en : Lang::ru));
  const std::string& hint = texts.hint_pattern(id, lang);
  if (!hint.empty()) text += fmt::format("  {}\n", hint);
  return text;
}

/// Returns all alarms that have this number on the control.
std::optional<std::string> numbered_alarms(const ControlDef& def, const AlarmTexts& texts, const std::string& number, Lang lang) {
  std::optional<std::string> text;
  for (std::size_t i = 0; i < static_cast<std::size_t>(AlarmId::count); ++i)
    if (const auto id = static_cast<AlarmId>(i); texts.number(id) == number) text = text.value_or("") + alarm_text_of(def, texts, id, lang);
  return text;
}

/// Finds alarms by the number with a prefix that the control displays: PS0114, error:33, ALARM:2.
std::optional<std::string> prefixed_alarms(const ControlDef& def, const AlarmTexts& texts, const std::string& what, Lang lang) {
  const std::size_t digits = what.find_first_of("0123456789");
  if (digits == std::string::npos || digits < 2 || what.find_first_not_of("0123456789", digits) != std::string::npos) return std::nullopt;
  std::optional<std::string> text;
  for (std::size_t i = 0; i < static_cast<std::size_t>(AlarmId::count); ++i) {
    const auto id = static_cast<AlarmId>(i);
    const std::string& pattern = texts.pattern(id, Lang::en);
    const std::string_view first = std::string_view(pattern).substr(0, pattern.find_first_of(" ,"));
    if (first.size() == what.size() &&
        std::equal(first.begin(), first.end(), what.begin(), [](char a, char b) { return to_upper(a) == to_upper(b); }))
      text = text.value_or("") + alarm_text_of(def, texts, id, lang);
  }
  return text;
}

/// Returns the text in small letters, both Latin and Russian (UTF-8: А to Я are D0 90 to D0 AF).
std::string small_letters(std::string_view text) {
  std::string small(text);
  for (std::size_t i = 0; i < small.size(); ++i) {
    if (is_capital(small[i])) small[i] = to_lower(small[i]);
    if (static_cast<unsigned char>(small[i]) != 0xD0 || i + 1 >= small.size()) continue;
    const auto next = static_cast<unsigned char>(small[i + 1]);
    if (next >= 0x90 && next <= 0x9F) small[i + 1] = static_cast<char>(next + 0x20);
    if (next >= 0xA0 && next <= 0xAF) small[i] = static_cast<char>(0xD1), small[i + 1] = static_cast<char>(next - 0x20);
  }
  return small;
}

/// Words that manuals use for the same thing. A search for one of the words also finds the others.
constexpr std::string_view same_words[][3] = {
    {"cutter", "radius", "contour"}, {"canned", "drilling", "cycle"}, {"fixture", "work zero", "work system"},
    {"home", "reference", ""},       {"pause", "dwell", ""},          {"фреза", "радиус", "эквидистант"},
    {"выдержка", "пауза", ""},       {"сверление", "цикл", ""}};

/// True if the text contains the word or a synonym of it. Both arguments must be in small letters.
bool has_word(const std::string& text, const std::string& word) {
  if (text.find(word) != std::string::npos) return true;
  for (const auto& group : same_words)
    if (std::find(std::begin(group), std::end(group), word) != std::end(group))
      return std::any_of(std::begin(group), std::end(group),
                         [&](std::string_view one) { return !one.empty() && text.find(one) != std::string::npos; });
  return false;
}

bool has_words(std::string_view text, std::string_view words) {
  const std::string small = small_letters(text), wanted = small_letters(words);
  for (std::size_t at = 0; at < wanted.size();) {
    const std::size_t end = std::min(wanted.find(' ', at), wanted.size());
    if (end > at && !has_word(small, wanted.substr(at, end - at))) return false;
    at = end + 1;
  }
  return true;
}

}  // namespace

std::optional<std::string> explain_words(const ControlDef& def, const AlarmTexts& texts, const std::string& words, Lang lang) {
  constexpr std::size_t least = 3;  // least length of a word for a search, bytes; a shorter text is treated as an address
  if (words.size() < least || words.find_first_not_of(' ') == std::string::npos) return std::nullopt;
  std::string found;
  const auto offer = [&](const std::string& name, const std::string& en, const std::string& ru) {
    if (has_words(en + " " + ru, words)) found += fmt::format("  {:<10}{}\n", name, lang == Lang::ru ? ru : en);
  };
  for (const CodeRow& row : def.codes) offer(row.code, row.text.en, row.text.ru);
  for (const CycleRow& row : def.cycles) offer(row.name, row.text.en, row.text.ru);
  for (const NameRow& row : named_rows(def)) offer(row.name, row.text.en, row.text.ru);
  for (const AddressRow& row : def.addresses)
    if (row.function != Function::count) offer(address_written(row.letter), row.text.en, row.text.ru);
  for (std::size_t i = 0; i < static_cast<std::size_t>(AlarmId::count); ++i) {
    const auto id = static_cast<AlarmId>(i);
    offer(std::string(name_of(id)) + " ", texts.pattern(id, Lang::en), texts.pattern(id, Lang::ru));
  }
  if (found.empty()) return std::nullopt;
  return fmt::format("{}: {}\n{}", def.id, words, found);
}

std::optional<std::string> explain_code(const ControlDef& def, const AlarmTexts& texts, const std::string& what, Lang lang) {
  const std::string code = code_named(what);
  if (const AlarmId id = alarm_named(what); id != no_alarm) return alarm_text_of(def, texts, id, lang);
  if (what.empty()) return std::nullopt;
  // the number may be that of an alarm and that of a parameter, so both are explained
  if (what.find_first_not_of("0123456789") == std::string::npos) {
    const auto alarms = numbered_alarms(def, texts, what, lang);
    const auto parameter = explain_parameter(def, code, lang);
    return alarms && parameter ? *alarms + *parameter : alarms ? alarms : parameter;
  }
  if (const auto alarms = prefixed_alarms(def, texts, what, lang)) return alarms;
  if (what[0] == '#') return explain_variable(def, what, lang);
  if (auto name = explain_name(def, what, lang)) return name;
  const bool comma = code.size() == 2 && code[0] == ',' && comma_address(code[1]) != 0;
  if (comma || (code.size() == 1 && code[0] >= 'A' && code[0] <= 'Z')) {
    const AddressRow& row = def.address(comma ? comma_address(code[1]) : code[0]);
    if (row.function == Function::count) return std::nullopt;
    return address_text(def, row, lang);
  }
  std::optional<std::string> text;
  if (code[0] == 'G' || code[0] == 'M') {
    char* end = nullptr;
    const double number = std::strtod(code.c_str() + 1, &end);
    const bool is_number = end != code.c_str() + 1 && *end == '\0' && number >= 0 && number * 10 < ControlDef::max_tenths;
    const std::int32_t row = is_number ? def.row_of(code[0], static_cast<std::int32_t>(std::lround(number * 10))) : -1;
    if (row >= 0) text = code_text(def, def.codes[static_cast<std::size_t>(row)], lang);
  }
  for (const CycleRow& row : def.cycles)
    if (row.name == code) return text.value_or("") + cycle_text(def, row, lang);
  if (!text) text = explain_parameter(def, code, lang);
  return text ? text : explain_variable(def, what, lang);
}

std::string explain_control(const ControlDef& def, Lang lang) {
  std::string text = fmt::format("{}: {}\n", def.id, in_language(def.name, lang));
  if (!def.lineage.empty() && !is_built_in(def)) text += fmt::format("  extends {}\n", def.lineage.front());
  if (!def.descriptor.empty()) text += fmt::format("  {}\n", def.descriptor);
  for (const CodeRow& row : def.codes) {
    std::string of_code = in_language(row.text, lang);
    if (!row.works) of_code = translated_in(lang, texts::explain_code::not_yet, of_code);
    else if (row.in_part) of_code = translated_in(lang, texts::explain_code::in_part, of_code);
    text += fmt::format("  {:<8}{:<2}{}\n", row.code, initial_mark(def, row), of_code);
  }
  for (const CycleRow& row : def.cycles)
    if (!row.body.empty() || row.name[0] == 'L') text += fmt::format("  {:<10}{}\n", row.name, in_language(row.text, lang));
  return text;
}

}  // namespace kadr
