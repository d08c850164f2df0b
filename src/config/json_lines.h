#pragma once
// JSON with the line of each key, for messages. Only setup*.cpp use it.

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace kadr {

struct JsonLines {
  nlohmann::json value;
  std::map<std::string, std::uint32_t> lines;  // "offsets.1.length", "events[0].when" → line, from 1
};

/// Why a text is no JSON, and where.
struct JsonFault {
  std::uint32_t line = 0;
  std::string en, ru;
};

/// law  value equals nlohmann::json::parse(text), where that is JSON no deeper than 64
tl::expected<JsonLines, JsonFault> json_with_lines(std::string_view text);

/// "offsets" and "1": "offsets.1".
inline std::string below(const std::string& inside, std::string_view key) {
  return inside.empty() ? std::string(key) : inside + "." + std::string(key);
}

}  // namespace kadr
