// Describes a parameter of a control, for commands such as `kadr explain nct N1339`. This file is used by out/text/explain/code_page.

#include "out/text/explain/parameter_text.h"

#include <fmt/core.h>

#include <array>

#include "out/text/in_language.h"
#include "texts/explain_code.h"
#include "texts/explain_parameter.h"

namespace kadr {
namespace {

namespace parameter_ids = texts::explain_parameter;

constexpr double unbounded = 1e299;
constexpr std::size_t bits_with_number = 8;  // number of bits that have numbers (0 to 7); further bits have only names (nct 24.0)

const char* scope_of(const ParameterRow& row, Lang lang) {
  constexpr std::array<PlainText, 4> scopes = {parameter_ids::one_for_control, parameter_ids::one_for_channel, parameter_ids::one_for_axis,
                                               parameter_ids::one_for_spindle};
  return plain_text(scopes[static_cast<std::size_t>(row.scope)], lang);
}

const char* type_of(const ParameterRow& row, Lang lang) {
  constexpr std::array<PlainText, 4> types = {parameter_ids::type_bits, parameter_ids::type_whole, parameter_ids::type_real,
                                              parameter_ids::type_text};
  return plain_text(types[static_cast<std::size_t>(row.type)], lang);
}

const char* when_of(const ParameterRow& row, Lang lang) {
  constexpr std::array<PlainText, 3> times = {parameter_ids::at_once, parameter_ids::after_power_on, parameter_ids::after_emergency_stop};
  return plain_text(times[static_cast<std::size_t>(row.when)], lang);
}

/// Returns the limits of the parameter in words, e.g. "0 … 100" or "at least 0"; empty for bits and texts, and for a parameter without
/// limits.
std::string allowed_values(const ParameterRow& row, Lang lang) {
  if (row.type == ParameterType::bits || row.type == ParameterType::text) return {};
  const bool least = row.least > -unbounded;
  const bool most = row.most < unbounded;
  const auto figure = [](double value) { return fmt::format("{:.12g}", value); };
  if (least && most) return figure(row.least) + " … " + figure(row.most);
  if (least) return translated_in(lang, parameter_ids::at_least, figure(row.least));
  if (most) return translated_in(lang, parameter_ids::at_most, figure(row.most));
  return {};
}

/// Returns the numbers and names of the bits, e.g. "0 DIA, 1 ROT, 5 MGD; numbers unknown: CLR".
std::string bits_of(const ParameterRow& row, Lang lang) {
  std::string known, others;
  for (std::size_t i = 0; i < row.bits.size(); ++i) {
    if (row.bits[i].empty()) continue;
    std::string& text = i < bits_with_number ? known : others;
    text += text.empty() ? "" : ", ";
    text += i < bits_with_number ? fmt::format("{} {}", i, row.bits[i]) : row.bits[i];
  }
  if (others.empty()) return known;
  return fmt::format("{}{}{}", known, known.empty() ? "" : "; ", translated_in(lang, parameter_ids::numbers_unknown, others));
}

std::string parameter_text(const ControlDef& def, const ParameterRow& row, Lang lang) {
  const bool russian = lang == Lang::ru && !row.text.ru.empty();
  std::string text = fmt::format("{} {}{}: {}\n", def.id, row.number < 0 ? "" : "N", row.name, in_language(row.text, lang));
  const auto line = [&](const std::string& words) { text += fmt::format("  {}\n", words); };
  const std::string bits = bits_of(row, lang), values = allowed_values(row, lang);
  if (russian && !row.text.en.empty()) line(translated_in(lang, parameter_ids::manual_name, row.text.en));
  line(translated_in(lang, parameter_ids::type_and_scope, type_of(row, lang), scope_of(row, lang)));
  if (!bits.empty()) line(translated_in(lang, parameter_ids::bits, bits));
  if (!values.empty()) line(translated_in(lang, parameter_ids::values, values));
  if (row.type != ParameterType::text) line(translated_in(lang, parameter_ids::initial, fmt::format("{:.12g}", row.initial)));
  line(translated_in(lang, parameter_ids::takes_effect, when_of(row, lang)));
  line(plain_text(row.used ? parameter_ids::obeyed : parameter_ids::without_effect, lang));
  line(translated_in(lang, texts::explain_code::source, def.spec, row.manual));
  return text;
}

}  // namespace

std::optional<std::string> explain_parameter(const ControlDef& def, const std::string& code, Lang lang) {
  const std::string_view digits = std::string_view(code).substr(code.starts_with('N') ? 1 : 0);
  const bool numbered = !digits.empty() && digits.size() <= 4 && digits.find_first_not_of("0123456789") == std::string_view::npos;
  const std::int32_t number = numbered ? std::stoi(std::string(digits)) : -1;
  for (const ParameterRow& row : def.parameters)
    if (numbered ? row.number == number : row.name == code) return parameter_text(def, row, lang);
  return std::nullopt;
}

}  // namespace kadr
