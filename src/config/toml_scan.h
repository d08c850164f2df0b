#pragma once
// Checks TOML text before it is parsed. toml++ calls itself for each level of nesting, and creates (and discards) a table for each part of
// a dotted key, so a text could exhaust the stack or the memory. This scan does not parse: it counts brackets and separators outside of
// strings, and checks limits.

#include <cstddef>
#include <string>
#include <string_view>

namespace kadr {

namespace limits {
// For comparison: the built-in files have depth 4, 3 parts of a key, and 6300 values.
inline constexpr std::size_t toml_depth = 32;      // greatest nesting depth of brackets in a value
inline constexpr std::size_t toml_key_parts = 16;  // greatest number of parts of a key or a heading; a.b.c has three parts
// Greatest number of keys, parts of keys and list elements, since each takes a hundred bytes of memory
inline constexpr std::size_t toml_values = 200'000;
}  // namespace limits

/// Checks the limits of a text. The parser finds other violations of TOML.
///   returns  an error sentence with file, line and column; empty if the text may be parsed
std::string toml_limit_message(std::string_view text, const std::string& file);

}  // namespace kadr
