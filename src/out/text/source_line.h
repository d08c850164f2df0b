#pragma once
// A line of a program as it is shown under an alarm: characters, not bytes, and marks under a part of them.

#include <cstdint>
#include <string>
#include <string_view>

#include "base/span.h"

namespace kadr {

/// Number of characters in the first `bytes` bytes of UTF-8 text.
std::uint32_t characters_before(std::string_view text, std::size_t bytes);

/// The line without blanks around it, cut off after so many characters.
std::string shortened_line(std::string_view line, std::size_t most);

/// The line and below it `^~~` under the characters of `place`; both indented, each ending in '\n'.
std::string marked_line(std::string_view line, Span place);

}  // namespace kadr
