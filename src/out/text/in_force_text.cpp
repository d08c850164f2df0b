// Describes in words the state in force. Used by cli/debug and cli/run (--from).

#include "out/text/in_force_text.h"

#include <fmt/core.h>

#include <algorithm>

#include "out/text/source_line.h"

namespace kadr {
namespace {

using Kind = InForce::Kind;

struct InForceRow {
  const char *en, *ru;
  std::vector<Kind> kinds;
};

const std::vector<InForceRow>& rows() {
  static const std::vector<InForceRow> all = {{"position", "положение", {Kind::position}},
                                              {"machine", "в станке", {Kind::machine}},
                                              {"codes", "коды", {Kind::code, Kind::feed, Kind::speed, Kind::spindle, Kind::coolant}},
                                              {"tool", "инструмент", {Kind::tool, Kind::selected, Kind::offset, Kind::length_offset}},
                                              {"length", "вылет", {Kind::length}},
                                              {"zero", "нуль детали", {Kind::origin}},
                                              {"rotation", "поворот", {Kind::rotation}},
                                              {"scale", "масштаб", {Kind::scale}},
                                              {"variables", "переменные", {Kind::variable}}};
  return all;
}

/// Returns the number with at most three decimals, without trailing zeros.
std::string short_number(double value) {
  std::string text = fmt::format("{:.3f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::size_t width(const std::string& text) { return characters_before(text, text.size()); }

std::string written(const InForce& one) {
  switch (one.kind) {
    case Kind::code:
    case Kind::spindle:
    case Kind::coolant: return one.code;
    case Kind::position:
    case Kind::machine:
    case Kind::origin:
    case Kind::length:
    case Kind::scale: return fmt::format("{} {}", one.name, short_number(one.value));
    case Kind::variable: return fmt::format("{}={:.9g}", one.name, one.value);
    case Kind::offset: return "D" + short_number(one.value);
    case Kind::length_offset: return "H" + short_number(one.value);
    default: return one.name + short_number(one.value);
  }
}

}  // namespace

std::string in_force_text(const std::vector<InForce>& all, Lang lang, const std::string& indent, std::size_t most) {
  std::size_t widest = 0;
  for (const InForceRow& row : rows()) widest = std::max(widest, width(lang == Lang::ru ? row.ru : row.en));
  std::string text;
  for (const InForceRow& row : rows()) {
    const std::string name = lang == Lang::ru ? row.ru : row.en;
    std::string line;
    std::size_t count = 0;
    const auto belongs = [&](const InForce& one) { return std::find(row.kinds.begin(), row.kinds.end(), one.kind) != row.kinds.end(); };
    const auto says_something = [&](const InForce& one) { return belongs(one) && (one.kind != Kind::length || one.value != 0); };
    if (std::none_of(all.begin(), all.end(), says_something)) continue;
    for (const InForce& one : all) {
      if (!belongs(one) || ++count > most) continue;
      line += " " + written(one);
    }
    if (count > most) line += fmt::format(" … ({})", count);
    text += indent + name + std::string(widest - width(name), ' ') + line + "\n";
  }
  return text;
}

}  // namespace kadr
