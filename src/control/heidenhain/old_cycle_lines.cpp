// Reads the lines of old cycles (spec/heidenhain 12.1). Used by control/heidenhain.

#include "control/heidenhain/old_cycle_lines.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "control/heidenhain/heidenhain.h"

namespace kadr::heidenhain {

std::optional<double> last_number(const std::string& line) {
  std::size_t end = line.find_last_of("0123456789");
  if (end == std::string::npos) return std::nullopt;
  std::size_t begin = end;
  while (begin > 0 && (std::string_view("0123456789.,").find(line[begin - 1]) != std::string_view::npos)) --begin;
  while (begin < end && (line[begin] == '.' || line[begin] == ',') && begin > 0 && line[begin - 1] >= 'A') ++begin;
  std::string digits = line.substr(begin, end - begin + 1);
  std::replace(digits.begin(), digits.end(), ',', '.');
  const double value = std::strtod(digits.c_str(), nullptr);
  std::size_t sign = begin;
  while (sign > 0 && line[sign - 1] == ' ') --sign;
  return sign > 0 && line[sign - 1] == '-' ? -value : value;
}

std::optional<std::uint16_t> named_parameter(const std::string& line) {
  const std::size_t at = line.find_last_of("Qq");
  if (at == std::string::npos || at + 1 >= line.size() || line[at + 1] < '0' || line[at + 1] > '9') return std::nullopt;
  const unsigned long index = std::strtoul(line.c_str() + at + 1, nullptr, 10);
  return index < q_count ? std::optional(static_cast<std::uint16_t>(index)) : std::nullopt;
}

std::string take_feed(std::string& line) {
  const auto is_letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
  for (std::size_t at = 0; at < line.size(); ++at) {
    if ((line[at] != 'F' && line[at] != 'f') || (at > 0 && is_letter(line[at - 1]))) continue;
    std::size_t begin = at + 1;
    while (begin < line.size() && line[begin] == ' ') ++begin;
    std::size_t end = begin;
    if (end < line.size() && (line[end] == 'Q' || line[end] == 'q')) ++end;
    while (end < line.size() && std::string_view("0123456789.,+").find(line[end]) != std::string_view::npos) ++end;
    if (end == begin) continue;
    std::string feed = line.substr(begin, end - begin);
    line.erase(at, end - at);
    return feed;
  }
  return {};
}

/// Takes the numbers of a line. A pocket or slot (3 to 5) also has its feed and its sense of rotation.
Status Heidenhain::take_old_line(BlockContext& m, const KlartextBlock& block) {
  const auto part = static_cast<std::size_t>(block.part);
  if (part >= memory.old.size()) return {};
  const auto number_in = [&](const std::string& text, double& to) -> Status {
    if (const auto index = named_parameter(text)) {
      const auto read = parameter(m, ParameterFamily::q, *index, m.block->where);
      if (!read) return fail(read.error());
      to = text.find("-Q") != std::string::npos ? -*read : *read;
    } else if (const auto number = last_number(text)) {
      to = *number;
    }
    return {};
  };
  std::string rest = block.text;
  if (block.number >= 3 && block.number <= 5) {
    KADR_TRY(number_in(take_feed(rest), memory.old_feed[part]));
    if (rest.find("DR+") != std::string::npos) memory.old_sense[part] = 1;
    if (rest.find("DR-") != std::string::npos) memory.old_sense[part] = -1;
  }
  return number_in(rest, memory.old[part]);
}

}  // namespace kadr::heidenhain
