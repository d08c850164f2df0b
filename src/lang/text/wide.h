#pragma once
// Reads characters above code 127 in valid UTF-8. Used by the lexer only.

#include <string_view>

namespace kadr {

/// One character above code 127, read from valid UTF-8.
struct Wide {
  char32_t code = 0;
  std::size_t bytes = 1;
};
inline Wide wide_at(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0u; };
  const unsigned lead = byte(0);
  if ((lead & 0xE0) == 0xC0) return {static_cast<char32_t>((lead & 0x1F) << 6 | (byte(1) & 0x3F)), 2};
  if ((lead & 0xF0) == 0xE0) return {static_cast<char32_t>((lead & 0x0F) << 12 | (byte(1) & 0x3F) << 6 | (byte(2) & 0x3F)), 3};
  return {static_cast<char32_t>((lead & 0x07) << 18 | (byte(1) & 0x3F) << 12 | (byte(2) & 0x3F) << 6 | (byte(3) & 0x3F)), 4};
}

}  // namespace kadr
