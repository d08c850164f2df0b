#pragma once
// Bytes as text (RFC 4648).

#include <optional>
#include <string>
#include <string_view>

namespace kadr {

std::string base64_of(std::string_view bytes);

/// Nothing: it is none, by the letter: no line ends, whole groups of four, no bits left over.
///   law  *bytes_of_base64(base64_of(b)) == b
std::optional<std::string> bytes_of_base64(std::string_view text);

}  // namespace kadr
