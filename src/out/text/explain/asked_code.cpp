// Normalises a code that a user types: Cyrillic or Latin, capital or small letters, with or without leading zeros. This file is used by cli
// and out.

#include "out/text/explain/asked_code.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "base/alarm.h"
#include "base/ascii.h"
#include "config/nearest.h"

namespace kadr {
namespace {

struct Lookalike {
  std::string_view cyrillic;
  char latin;
};
// Cyrillic capital and small letters, each with the Latin letter that looks alike. У also stands for Y, as on a Soviet keyboard.
constexpr std::array<Lookalike, 24> lookalikes = {{{"А", 'A'}, {"В", 'B'}, {"С", 'C'}, {"Е", 'E'}, {"Н", 'H'}, {"К", 'K'},
                                                   {"М", 'M'}, {"О", 'O'}, {"Р", 'P'}, {"Т", 'T'}, {"Х", 'X'}, {"У", 'Y'},
                                                   {"а", 'A'}, {"в", 'B'}, {"с", 'C'}, {"е", 'E'}, {"н", 'H'}, {"к", 'K'},
                                                   {"м", 'M'}, {"о", 'O'}, {"р", 'P'}, {"т", 'T'}, {"х", 'X'}, {"у", 'Y'}}};

std::string latin_capitals(std::string_view what) {
  std::string text;
  while (!what.empty()) {
    const auto* const found =
        std::find_if(lookalikes.begin(), lookalikes.end(), [&](const Lookalike& one) { return what.starts_with(one.cyrillic); });
    const bool cyrillic = found != lookalikes.end();
    const char c = cyrillic ? found->latin : what.front();
    text += to_upper(c);
    what.remove_prefix(cyrillic ? found->cyrillic.size() : 1);
  }
  return text;
}

/// Returns the number after a single letter, e.g. 5.1 for "G5.1"; nullopt if the text has another form.
std::optional<double> number_of(const std::string& code) {
  if (code.size() < 2 || !is_capital(code[0]) || code.find_first_not_of("0123456789.", 1) != std::string::npos) return std::nullopt;
  char* end = nullptr;
  const double number = std::strtod(code.c_str() + 1, &end);
  if (*end != '\0' || end == code.c_str() + 1) return std::nullopt;
  return number;
}

/// Returns those names of the control that begin with the letter of the code. They are sorted by the distance of their number from that of
/// the code.
std::vector<std::string> nearest_numbers(const ControlDef& def, const std::string& code, double number) {
  std::vector<std::pair<double, std::string>> found;
  const auto offer = [&](const std::string& name) {
    if (name.empty() || name[0] != code[0]) return;
    if (const auto other = number_of(name)) found.emplace_back(std::fabs(*other - number), name);
  };
  for (const CodeRow& row : def.codes) offer(row.code);
  for (const CycleRow& row : def.cycles) offer(row.name);
  for (const ParameterRow& row : def.parameters) offer("N" + row.name);
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  constexpr double farthest = 10;  // greatest difference of numbers at which a name is proposed; a more distant name does not help the user
  std::vector<std::string> names;
  for (const auto& [distance, name] : found)
    if (distance <= farthest && names.size() < 3 && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

}  // namespace

std::string code_named(std::string_view what) {
  std::string code = latin_capitals(what);
  if (code.empty() || !is_capital(code[0])) return code;
  const std::size_t digits = code.find_first_not_of('0', 1);
  if (!number_of(code) || code[0] == 'N') return code;  // N0107 is a parameter, whose leading zeros are significant
  code.erase(1, (digits == std::string::npos || code[digits] == '.' ? std::min(digits, code.size()) - 1 : digits) - 1);
  if (code.find('.') == std::string::npos) return code;
  code.erase(code.find_last_not_of('0') + 1);
  if (code.back() == '.') code.pop_back();
  return code;
}

std::vector<std::string> nearest_to(const ControlDef& def, const std::string& what) {
  const std::string code = code_named(what);
  const bool digits = !what.empty() && what.find_first_not_of("0123456789") == std::string::npos;
  const std::string asked = digits && what.size() <= 4 ? "N" + what : code;
  if (const auto number = number_of(asked)) return nearest_numbers(def, asked, *number);
  std::vector<std::string> known;
  for (const VariableRow& row : def.variables)
    if (!row.symbol.empty()) known.push_back(row.symbol);
  for (const ParameterRow& row : def.parameters)
    if (row.number < 0) known.push_back(row.name);
  for (std::size_t i = 0; i < static_cast<std::size_t>(AlarmId::count); ++i) known.emplace_back(name_of(static_cast<AlarmId>(i)));
  if (const auto name = what.size() > 2 ? nearest(what, known) : std::nullopt) return {*name};
  return {};
}

}  // namespace kadr
