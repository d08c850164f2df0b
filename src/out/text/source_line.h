#pragma once
// Shows a program line below an alarm and underlines a range of the line. Positions count characters, not bytes.

#include <cstdint>
#include <string>
#include <string_view>

#include "base/span.h"

namespace kadr {

/// Returns the number of characters in the first `bytes` bytes of a UTF-8 text.
std::uint32_t characters_before(std::string_view text, std::size_t bytes);

/// Returns the text with all control characters replaced by their symbols (U+2400 and above). Characters without a symbol are replaced by
/// U+FFFD: C1 controls as characters or single bytes, and characters that reverse the writing direction. Tabs and line feeds remain.
std::string visible(std::string_view text);
/// Does the same as visible() for a name, in which tabs and line feeds are replaced too.
std::string visible_name(std::string_view name);

/// Returns the line without blanks at its beginning and end, shortened to at most `most` characters.
std::string shortened_line(std::string_view line, std::size_t most);

/// Returns the line, and below it `^~~` under the characters of the range `place`. Both lines are indented and end in '\n'.
std::string marked_line(std::string_view line, Span place);

}  // namespace kadr
