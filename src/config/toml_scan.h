#pragma once
// Checks TOML text before it is parsed. toml++ recurses for each level, and creates (and discards) a table for each part of a dotted key,
// so a text could exhaust the stack or much memory. This scan looks at brackets and strings only and checks limits.

#include <cstddef>
#include <string>
#include <string_view>

namespace kadr {

namespace limits {
// The built-in files have depth 4, 3 parts, 6300 values.
inline constexpr std::size_t toml_depth = 32;        // greatest nesting of brackets in a value
inline constexpr std::size_t toml_key_parts = 16;    // greatest number of parts of a key or a heading; a.b.c has three
inline constexpr std::size_t toml_values = 200'000;  // greatest number of keys, parts of keys, items of lists; each takes a hundred bytes
}  // namespace limits

/// Checks the limits of a text. Other violations of TOML are left to the parser.
///   returns  an error sentence with file, line and column; empty if the text may be parsed
std::string toml_limit_message(std::string_view text, const std::string& file);

}  // namespace kadr
