// Describes a system variable: its numbers, its symbol, and whether a program may read or change it. This file is used by
// out/text/explain/code_page and out/text/explain/control_page.

#include "out/text/explain/variable_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

#include "base/ascii.h"
#include "out/text/in_language.h"
#include "texts/explain_code.h"
#include "texts/explain_variable.h"

namespace kadr {
namespace {

namespace variable_ids = texts::explain_variable;

/// The location of a number in the number ranges of a variable: index of the range, and index within the range.
struct Place {
  std::uint32_t family = 0;
  std::uint32_t nth = 0;
};

std::optional<Place> place_in(const VariableRange& range, std::uint32_t number) {
  if (number < range.from) return std::nullopt;
  const std::uint32_t beyond = number - range.from;
  const std::uint32_t family = range.stride == 0 ? 0 : beyond / range.stride;
  const std::uint32_t nth = beyond - family * range.stride;
  if (family >= range.repeat || nth >= range.count) return std::nullopt;
  return Place{family, nth};
}

std::string of_many(const VariableRow& row, std::uint32_t family, const std::string& index) {
  const bool families = row.ranges.back().repeat > 1;
  return fmt::format("#_{}{}{}", row.symbol, families ? std::to_string(family + 1) : "", index);
}

std::string explained(const ControlDef& def, const VariableRow& row, const std::string& name, Lang lang) {
  std::string text = fmt::format("{} {}: {}\n", def.id, name, in_language(row.text, lang));
  if (const std::string numbers = numbers_of(def, row, lang); !numbers.empty() && numbers != name)
    text += fmt::format("  {}\n", translated_in(lang, variable_ids::numbers, numbers));
  if (const std::string symbol = symbol_of(row); !symbol.empty() && symbol != name)
    text += fmt::format("  {}\n", translated_in(lang, variable_ids::symbol, symbol));
  if (!row.write) text += fmt::format("  {}\n", plain_text(variable_ids::read_only, lang));
  if (!row.read) text += fmt::format("  {}\n", plain_text(variable_ids::write_only, lang));
  if (!row.works) text += fmt::format("  {}\n", plain_text(variable_ids::without_effect, lang));
  return text + fmt::format("  {}\n", translated_in(lang, texts::explain_code::source, def.spec, row.manual));
}

std::optional<std::string> by_number(const ControlDef& def, std::uint32_t number, Lang lang) {
  for (const VariableRow& row : def.variables)
    for (const VariableRange& range : row.ranges) {
      const auto place = place_in(range, number);
      if (!place) continue;
      std::string name = fmt::format("#{}", number);
      if (!row.symbol.empty()) {
        const bool many = row.ranges.back().count > 1;
        name += " " + of_many(row, place->family, many ? fmt::format("[{}]", row.first_index + place->nth) : "");
      }
      return explained(def, row, name, lang);
    }
  return std::nullopt;
}

}  // namespace

std::string numbers_of(const ControlDef& def, const VariableRow& row, Lang lang) {
  if (row.bit >= 0) {
    std::string whole = fmt::format("#{}", row.of);
    for (const VariableRow& other : def.variables)
      if (other.bit < 0 && other.ranges.front().from == row.of && row.of > first_unwritten_variable) whole = symbol_of(other);
    return translated_in(lang, variable_ids::bit_of, row.bit, whole);
  }
  std::string text;
  for (const VariableRange& range : row.ranges) {
    if (range.from > first_unwritten_variable) continue;
    std::string numbers = fmt::format("#{}", range.from);
    if (range.count > 1) numbers += fmt::format("–#{}", range.from + range.count - 1);
    if (range.repeat > 1) numbers = translated_in(lang, variable_ids::numbers_repeated, numbers, range.stride, range.repeat);
    text += (text.empty() ? "" : ", ") + numbers;
  }
  return text;
}

std::string symbol_of(const VariableRow& row) {
  if (row.symbol.empty()) return {};
  const VariableRange& range = row.ranges.back();
  const std::string index = range.count > 1 ? fmt::format("[{}–{}]", row.first_index, row.first_index + range.count - 1) : "";
  std::string text = of_many(row, 0, index);
  if (range.repeat > 1) text += " … " + of_many(row, range.repeat - 1, index);
  return text;
}

std::optional<std::string> explain_variable(const ControlDef& def, const std::string& what, Lang lang) {
  const std::size_t start = what.find_first_not_of("#_");
  if (start == std::string::npos) return std::nullopt;
  std::string name = what.substr(start, what.find('[') - start);
  if (what[0] == '#' && std::all_of(name.begin(), name.end(), is_digit) && name.size() <= 9)
    return by_number(def, static_cast<std::uint32_t>(std::stoul(name)), lang);
  for (char& c : name) c = to_upper(c);
  const std::string family = name.substr(0, name.find_last_not_of("0123456789") + 1);
  for (const VariableRow& row : def.variables) {
    if (row.symbol.empty()) continue;
    if (row.symbol == name || (row.symbol == family && row.ranges.back().repeat > 1)) return explained(def, row, symbol_of(row), lang);
  }
  return std::nullopt;
}

}  // namespace kadr
