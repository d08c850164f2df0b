#pragma once
// A line of a program as it is shown under an alarm: characters, not bytes, and marks under a part of them.

#include <cstdint>
#include <string>
#include <string_view>

#include "base/span.h"

namespace kadr {

/// Number of characters in the first `bytes` bytes of UTF-8 text.
std::uint32_t characters_before(std::string_view text, std::size_t bytes);

/// The text with its control characters as pictures, U+2400 and on, where there are none (C1, lone bytes of it, the order of writing turned
/// round) as U+FFFD; tabs and line feeds stay.
std::string visible(std::string_view text);
/// The same of a name, which has no lines.
std::string visible_name(std::string_view name);

/// The line without blanks around it, cut off after so many characters.
std::string shortened_line(std::string_view line, std::size_t most);

/// The line and below it `^~~` under the characters of `place`; both indented, each ending in '\n'.
std::string marked_line(std::string_view line, Span place);

}  // namespace kadr
