#pragma once
// Checks JSON text before it is parsed. A fault is reported in words, with line and column, and a text that could exhaust the stack or the
// memory is rejected. The check is stricter than the parser in one respect: a key must not occur twice in a table.

#include <cstddef>
#include <string>
#include <string_view>

namespace kadr {

namespace limits {
inline constexpr std::size_t json_depth = 32;        // greatest nesting depth of brackets; a set-up has depth 5
inline constexpr std::size_t json_values = 500'000;  // greatest number of values, since each takes some eighty bytes of memory
}  // namespace limits

/// Checks that the text is JSON in UTF-8 within the limits.
///   returns  an error sentence with file (if given), line and column; empty if the text may be parsed
std::string json_fault_message(std::string_view text, const std::string& file);

}  // namespace kadr
