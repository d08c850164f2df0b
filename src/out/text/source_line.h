#pragma once
// Shows a line of a program under an alarm: counts characters, not bytes, and marks a part of them.

#include <cstdint>
#include <string>
#include <string_view>

#include "base/span.h"

namespace kadr {

/// Returns the number of characters in the first `bytes` bytes of UTF-8 text.
std::uint32_t characters_before(std::string_view text, std::size_t bytes);

/// Returns the text with its control characters as pictures (U+2400 and up), and as U+FFFD those without a picture (C1 as characters or
/// lone bytes, marks that reverse the direction of writing). Tabs and line feeds stay.
std::string visible(std::string_view text);
/// The same for a name, which has no lines.
std::string visible_name(std::string_view name);

/// Returns the line without surrounding blanks, cut off after `most` characters.
std::string shortened_line(std::string_view line, std::size_t most);

/// Returns the line, and below it `^~~` under the characters of `place`; both indented, each ending in '\n'.
std::string marked_line(std::string_view line, Span place);

}  // namespace kadr
