#pragma once
// Base64 (RFC 4648): an encoding of bytes as text.

#include <optional>
#include <string>
#include <string_view>

namespace kadr {

std::string base64_of(std::string_view bytes);

/// Decodes a text. Returns nullopt if the text is not strict base64, which has no line breaks, complete groups of four characters, and
/// unused bits of value 0.
///   law  *bytes_of_base64(base64_of(b)) == b
std::optional<std::string> bytes_of_base64(std::string_view text);

}  // namespace kadr
