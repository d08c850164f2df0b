// Describes in words what is in force on the control: modes, tool, offsets, variables. This file is used by cli/debug and cli/run (--from).

#include "out/text/in_force_text.h"

#include <fmt/core.h>

#include <algorithm>

#include "out/text/source_line.h"
#include "texts/in_force.h"

namespace kadr {
namespace {

using Kind = InForce::Kind;

struct InForceRow {
  PlainText name;
  std::vector<Kind> kinds;
};

const std::vector<InForceRow>& rows() {
  static const std::vector<InForceRow> all = {{texts::in_force::position, {Kind::position}},
                                              {texts::in_force::machine, {Kind::machine}},
                                              {texts::in_force::codes, {Kind::code, Kind::feed, Kind::speed, Kind::spindle, Kind::coolant}},
                                              {texts::in_force::tool, {Kind::tool, Kind::selected, Kind::offset, Kind::length_offset}},
                                              {texts::in_force::tool_length, {Kind::length}},
                                              {texts::in_force::work_zero, {Kind::origin}},
                                              {texts::in_force::rotation, {Kind::rotation}},
                                              {texts::in_force::scale, {Kind::scale}},
                                              {texts::in_force::variables, {Kind::variable}}};
  return all;
}

/// Formats the number with at most three decimals and without zeros at the end.
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
  for (const InForceRow& row : rows()) widest = std::max(widest, width(plain_text(row.name, lang)));
  std::string text;
  for (const InForceRow& row : rows()) {
    const std::string name = plain_text(row.name, lang);
    std::string line;
    std::size_t count = 0;
    const auto belongs = [&](const InForce& one) { return std::find(row.kinds.begin(), row.kinds.end(), one.kind) != row.kinds.end(); };
    const auto is_shown = [&](const InForce& one) { return belongs(one) && (one.kind != Kind::length || one.value != 0); };
    if (std::none_of(all.begin(), all.end(), is_shown)) continue;
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
