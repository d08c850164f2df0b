// Texts of alarms: controls/alarms.toml in English and Russian, and the control's own numbers and wording, which take precedence. Used by
// cli, config, out; tested by tests/config/alarm_texts_test.cpp.

#include "config/alarm_texts.h"

#include <fmt/format.h>

#include <cmath>

#include "config/embedded.h"
#include "config/packed_toml.h"
#include "texts/alarm_units.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;

constexpr std::string_view file_name = "controls/alarms.toml";

/// Translates an argument, which is a unit or a number with a unit, into the language of the sentence.
std::string with_unit(std::string_view text, Lang lang) {
  constexpr std::pair<std::string_view, PlainText> units[] = {{"mm/min", texts::alarm_units::mm_per_min},
                                                              {"mm/rev", texts::alarm_units::mm_per_rev},
                                                              {"1/min", texts::alarm_units::per_min},
                                                              {"rev/min", texts::alarm_units::rev_per_min},
                                                              {"mm", texts::alarm_units::mm},
                                                              {"in", texts::alarm_units::inch},
                                                              {"s", texts::alarm_units::second}};
  const std::size_t space = text.rfind(' ');
  const std::string_view before = space == std::string_view::npos ? std::string_view() : text.substr(0, space + 1);
  const bool figure = before.find_first_not_of("+-.0123456789e ") == std::string_view::npos;
  for (const auto& [name, unit] : units)
    if (figure && text.substr(before.size()) == name) return std::string(before) + plain_text(unit, lang);
  return std::string(text);
}

/// Formats an argument of an alarm. A number is rounded to 0.001, which is precise enough in a shop; a number below 0.01 gets six decimals.
std::string text_of(const AlarmArg& arg, Lang lang) {
  if (!arg.is_number()) return with_unit(arg.text(), lang);
  // The value NaN stands for a macro variable that is vacant, so the word "vacant" is printed instead of a number
  if (std::isnan(arg.number())) return plain_text(texts::alarm_units::vacant, lang);
  return number_text(arg.number(), std::fabs(arg.number()) >= 0.01 ? 3 : 6);
}

/// Returns `pattern` with {0} {1} {2} replaced by the arguments.
std::string filled(const std::string& pattern, const Alarm& alarm, Lang lang) {
  std::string text;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const bool hole =
        pattern[i] == '{' && i + 2 < pattern.size() && pattern[i + 2] == '}' && pattern[i + 1] >= '0' && pattern[i + 1] <= '2';
    if (!hole) {
      text += pattern[i];
      continue;
    }
    const auto nth = static_cast<std::size_t>(pattern[i + 1] - '0');
    text += nth < alarm.arg_count ? text_of(alarm.args[nth], lang) : "?";
    i += 2;
  }
  return text;
}

/// Returns the text in the requested language; if it is missing, the text in the other language.
const std::string& in(const Text& text, Lang lang) {
  const std::string& own = lang == Lang::ru ? text.ru : text.en;
  return !own.empty() ? own : lang == Lang::ru ? text.en : text.ru;
}

/// Returns the member of AlarmText that stores the text of a key, such as "hint_en"; nullptr for any other key. The key `args` is never
/// looked up, because its value is not a text.
std::string* place_of(AlarmText& row, std::string_view key) {
  if (key == "en") return &row.text.en;
  if (key == "ru") return &row.text.ru;
  if (key == "hint_en") return &row.hint.en;
  return key == "hint_ru" ? &row.hint.ru : nullptr;
}

void overlay(AlarmText& row, const AlarmText& own) {
  const auto take = [](std::string& to, const std::string& from) {
    if (!from.empty()) to = from;
  };
  take(row.number, own.number);
  take(row.text.en, own.text.en);
  take(row.text.ru, own.text.ru);
  take(row.hint.en, own.hint.en);
  take(row.hint.ru, own.hint.ru);
}

}  // namespace

tl::expected<AlarmTexts, std::string> AlarmTexts::load(const ControlDef* def) {
  AlarmTexts texts;
  std::string fault;
  each_text(embedded(file_name)->table, [&](std::string_view name, std::string_view key, std::string_view text) {
    const AlarmId id = alarm_named(name);
    if (id == no_alarm) {
      fault = "no alarm '" + std::string(name) + "'";
      return;
    }
    if (std::string* const to = place_of(texts.rows_[static_cast<std::size_t>(id)], key)) *to = text;
    else if (key != "severity") fault = "unknown key '" + std::string(key) + "'";
  });
  if (!fault.empty()) return Failed(std::string(file_name) + ": " + fault);
  if (def != nullptr)
    for (const auto& [id, own] : def->alarms) overlay(texts.rows_[static_cast<std::size_t>(id)], own);
  return texts;
}

std::string AlarmTexts::sentence(const Alarm& alarm, Lang lang) const {
  const std::string& pattern = in(row(alarm.id).text, lang);
  if (!pattern.empty()) return filled(pattern, alarm, lang);
  std::string text(alarm.id == no_alarm ? "alarm" : name_of(alarm.id));
  for (std::size_t i = 0; i < alarm.arg_count; ++i) text.append(i == 0 ? ": " : ", ").append(text_of(alarm.args[i], lang));
  return text;
}

std::string AlarmTexts::number(const Alarm& alarm) const { return filled(row(alarm.id).number, alarm, Lang::en); }

std::string AlarmTexts::hint(const Alarm& alarm, Lang lang) const { return filled(in(row(alarm.id).hint, lang), alarm, lang); }

const std::string& AlarmTexts::pattern(AlarmId id, Lang lang) const { return in(row(id).text, lang); }

const std::string& AlarmTexts::hint_pattern(AlarmId id, Lang lang) const { return in(row(id).hint, lang); }

std::string number_text(double value, int decimals) {
  if (!std::isfinite(value)) return fmt::format("{}", value);
  if (std::abs(value) >= 1e15) return fmt::format("{:g}", value);
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

}  // namespace kadr
