#pragma once
// A look over JSON text before it is parsed: what is wrong is told in words, with line and column, and no text takes the stack or the
// memory. Stricter than the parser in one thing: a key may stand once in a table.

#include <cstddef>
#include <string>
#include <string_view>

namespace kadr {

namespace limits {
inline constexpr std::size_t json_depth = 32;        // of brackets in brackets; a set-up has 5
inline constexpr std::size_t json_values = 500'000;  // some eighty bytes each
}  // namespace limits

/// Is it JSON, in UTF-8, within the limits?
///   returns  an error sentence with file (where one is given), line and column; empty: it may be parsed
std::string told_json_fault(std::string_view text, const std::string& file);

}  // namespace kadr
