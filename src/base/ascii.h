// Character classes that do not depend on the locale. They know only ASCII, because every character that has a meaning in a program is
// ASCII.
#pragma once

#include <string_view>

namespace kadr {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
constexpr bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
constexpr bool is_letter(char c) { return is_capital(c) || is_lower(c); }
constexpr char to_upper(char c) { return is_lower(c) ? static_cast<char>(c - 'a' + 'A') : c; }
constexpr char to_lower(char c) { return is_capital(c) ? static_cast<char>(c - 'A' + 'a') : c; }

/// True for a byte outside ASCII. In every encoding that Kadr reads, such a byte is part of a Cyrillic letter.
constexpr bool is_high(char c) { return static_cast<unsigned char>(c) >= 0x80; }

/// Returns true if the text is not empty and every character satisfies `is`.
constexpr bool all_are(std::string_view text, bool (*is)(char)) {
  for (const char c : text)
    if (!is(c)) return false;
  return !text.empty();
}

}  // namespace kadr
