#pragma once
// Reads the text of a block with names (spec/sinumerik 2, 3, 7 to 9) into a NamedBlock.

#include <string_view>

#include "base/result.h"
#include "lang/named/named_block.h"

namespace kadr {

/// Reads a block, without its number, label and comment. Locations count from the start of `line`.
///   alarms  expression_syntax, bracket_not_closed, number_damaged, nesting_too_deep, comparison_chained, unexpected_character
Result<NamedBlock> read_named_block(std::string_view line, Span text);

/// Returns the first name of the text in upper case, such as IF, ENDLOOP; empty if the text does not begin with a name of at least two
/// letters.
std::string leading_name(std::string_view text);

/// Returns true if the text contains the word (in any letter case) outside of quotes, between signs that are not part of names.
bool has_name(std::string_view text, std::string_view name);

inline bool begins_name(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; }
inline bool continues_name(char c) { return begins_name(c) || (c >= '0' && c <= '9'); }

}  // namespace kadr
