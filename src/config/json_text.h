#pragma once
// Text to JSON and back. Files call these functions rather than nlohmann's members parse() and dump(), because each unit that calls those
// compiles the whole parser and writer again: two seconds for each kind of value.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace kadr {

/// Parses JSON, whose objects are sorted by key in the result. Returns a discarded value (is_discarded()) if the text is not JSON.
nlohmann::json json_of(std::string_view text);

/// Parses JSON; objects keep the order of the text. Returns a discarded value (is_discarded()) if the text is not JSON.
nlohmann::ordered_json ordered_json_of(std::string_view text);

/// Returns the text of a value, with `indent` blanks a level; on one line if it is negative. A byte that is not UTF-8 becomes U+FFFD.
std::string json_text(const nlohmann::json& value, int indent = -1);
std::string json_text(const nlohmann::ordered_json& value, int indent = -1);

}  // namespace kadr
