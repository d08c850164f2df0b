// Describes a parameter of a control, for commands such as `kadr explain nct N1339`. Used by out/text/explain/code_page.

#include "out/text/explain/parameter_text.h"

#include <fmt/core.h>

#include <array>

#include "out/text/in_language.h"

namespace kadr {
namespace {

constexpr double unbounded = 1e299;
constexpr std::size_t bits_with_number = 8;  // the bits after these have a name only (24.0)

std::string_view scope_of(const ParameterRow& row, Lang lang) {
  constexpr std::array<BothLanguages, 4> words = {{{"the control has one", "одно на всё УЧПУ"},
                                                   {"one for each channel", "своё у каждого канала"},
                                                   {"one for each axis", "своё у каждой оси"},
                                                   {"one for each spindle", "своё у каждого шпинделя"}}};
  return in_language(words[static_cast<std::size_t>(row.scope)], lang);
}

std::string_view type_of(const ParameterRow& row, Lang lang) {
  constexpr std::array<BothLanguages, 4> words = {
      {{"bits", "разряды"}, {"whole number", "целое число"}, {"real number", "вещественное число"}, {"text", "текст"}}};
  return in_language(words[static_cast<std::size_t>(row.type)], lang);
}

std::string_view when_of(const ParameterRow& row, Lang lang) {
  constexpr std::array<BothLanguages, 3> words = {{{"at once", "сразу"},
                                                   {"after power-on; G10 L52 refuses it", "после включения; G10 L52 его не принимает"},
                                                   {"after an emergency stop", "после аварийного останова"}}};
  return in_language(words[static_cast<std::size_t>(row.when)], lang);
}

/// Returns "0 … 100" or "at least 0"; empty for bits and texts, and for a parameter without limits.
std::string allowed_values(const ParameterRow& row, Lang lang) {
  if (row.type == ParameterType::bits || row.type == ParameterType::text) return {};
  const bool least = row.least > -unbounded;
  const bool most = row.most < unbounded;
  const auto figure = [](double value) { return fmt::format("{:.12g}", value); };
  if (least && most) return figure(row.least) + " … " + figure(row.most);
  if (least) return fmt::format("{} {}", lang == Lang::ru ? "не меньше" : "at least", figure(row.least));
  if (most) return fmt::format("{} {}", lang == Lang::ru ? "не больше" : "at most", figure(row.most));
  return {};
}

/// Returns the names of the bits: "0 DIA, 1 ROT, 5 MGD; numbers unknown: CLR".
std::string bits_of(const ParameterRow& row, Lang lang) {
  std::string known, others;
  for (std::size_t i = 0; i < row.bits.size(); ++i) {
    if (row.bits[i].empty()) continue;
    std::string& text = i < bits_with_number ? known : others;
    text += text.empty() ? "" : ", ";
    text += i < bits_with_number ? fmt::format("{} {}", i, row.bits[i]) : row.bits[i];
  }
  if (others.empty()) return known;
  return fmt::format("{}{}{}: {}", known, known.empty() ? "" : "; ", lang == Lang::ru ? "номера неизвестны" : "numbers unknown", others);
}

std::string parameter_text(const ControlDef& def, const ParameterRow& row, Lang lang) {
  const bool ru = lang == Lang::ru;
  const bool russian = ru && !row.text.ru.empty();
  std::string text = fmt::format("{} {}{}: {}\n", def.id, row.number < 0 ? "" : "N", row.name, russian ? row.text.ru : row.text.en);
  const auto line = [&](std::string_view head, std::string_view value) {
    if (!value.empty()) text += fmt::format("  {}: {}\n", head, value);
  };
  if (russian) line("имя в руководстве", row.text.en);
  line(ru ? "вид" : "type", fmt::format("{}, {}", type_of(row, lang), scope_of(row, lang)));
  line(ru ? "биты" : "bits", bits_of(row, lang));
  line(ru ? "пределы" : "values", allowed_values(row, lang));
  if (row.type != ParameterType::text) line(ru ? "исходное" : "default", fmt::format("{:.12g}", row.initial));
  line(ru ? "вступает в силу" : "takes effect", when_of(row, lang));
  text += fmt::format("  {}\n", row.used ? (ru ? "Kadr его учитывает" : "Kadr obeys it")
                                         : (ru ? "в Kadr не действует: хранится, читается и записывается программой"
                                               : "without effect in Kadr: kept, read and written by programs"));
  line(ru ? "источник" : "source", fmt::format("{}, {}", def.spec, row.manual));
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
