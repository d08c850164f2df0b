#pragma once
// A look over TOML text before it is parsed. toml++ goes down a call a level, and makes (and throws away) a table a part of a dotted key:
// a text may take its stack, or much memory. This looks at brackets and strings alone, and holds them against limits.

#include <cstddef>
#include <string>
#include <string_view>

namespace kadr {

namespace limits {
// Our own files: 4 deep, 3 parts, 6300 values.
inline constexpr std::size_t toml_depth = 32;        // of brackets in brackets, of a value
inline constexpr std::size_t toml_key_parts = 16;    // of a key, a.b.c has three; of a heading too
inline constexpr std::size_t toml_values = 200'000;  // keys, parts of keys, items of lists: a hundred bytes each
}  // namespace limits

/// Holds a text against the limits; what is no TOML otherwise is left to the parser.
///   returns  an error sentence with file, line and column; empty: it may be parsed
std::string told_toml_limit(std::string_view text, const std::string& file);

}  // namespace kadr
