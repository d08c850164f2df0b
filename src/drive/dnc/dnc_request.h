#pragma once
// dnc_request: what a received text is for: a program, or a request of the control for a program.

#include <optional>
#include <string>
#include <string_view>

namespace kadr::drive {

/// Returns the name of the program that a received text requests: the text has no block but a program number and the comment
/// `(SEND NAME)`. A name has letters, digits, `-`, `_` and `.`, and does not begin with a point.
std::optional<std::string> requested_program(std::string_view text);

/// Returns the file name for a received program: its number as it is written, "O1234" or "%12", else "program".
std::string name_of_program(std::string_view text);

}  // namespace kadr::drive
