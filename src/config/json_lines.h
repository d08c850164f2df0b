#pragma once
// Parses JSON and records the line number of each key, for messages. Only setup*.cpp use it.

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace kadr {

struct JsonLines {
  nlohmann::json value;
  // Full name of a key, such as "offsets.1.length" or "events[0].when" → its line number, from 1
  std::map<std::string, std::uint32_t> lines;
};

/// The reason why a text is not JSON, and the line of the fault.
struct JsonFault {
  std::uint32_t line = 0;
  std::string en, ru;
};

/// Parses JSON; the result also contains the line number of each key.
///   law  the parsed value equals nlohmann::json::parse(text) if the text is JSON, nested no deeper than 64
tl::expected<JsonLines, JsonFault> json_with_lines(std::string_view text);

/// Joins "offsets" and "1" to "offsets.1".
inline std::string below(const std::string& inside, std::string_view key) {
  return inside.empty() ? std::string(key) : inside + "." + std::string(key);
}

}  // namespace kadr
