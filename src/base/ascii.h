// Kinds of characters, whatever the locale: programs are ASCII where they mean something.
#pragma once

#include <string_view>

namespace kadr {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
constexpr bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
constexpr bool is_letter(char c) { return is_capital(c) || is_lower(c); }
constexpr char to_upper(char c) { return is_lower(c) ? static_cast<char>(c - 'a' + 'A') : c; }
constexpr char to_lower(char c) { return is_capital(c) ? static_cast<char>(c - 'A' + 'a') : c; }

/// A byte that ASCII does not have: part of a Cyrillic letter, in every encoding that is read.
constexpr bool is_high(char c) { return static_cast<unsigned char>(c) >= 0x80; }

/// Is there any, and is each one of that kind?
constexpr bool all_are(std::string_view text, bool (*is)(char)) {
  for (const char c : text)
    if (!is(c)) return false;
  return !text.empty();
}

}  // namespace kadr
