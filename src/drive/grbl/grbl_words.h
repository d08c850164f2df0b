#pragma once
// grbl_words: the words of a line as Grbl's filter leaves it.

#include <cmath>
#include <string>
#include <string_view>

#include "lang/block/line_word_reader.h"

namespace kadr::drive {

/// Calls `use` with each word of a filtered line: its letter, its number, and where it begins and ends.
template <class Use>
void each_word(std::string_view text, Use use) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t size = size_of_number(text.substr(at + 1));
    use(text[at], value_of_digits(text.substr(at + 1, size)), at, at + 1 + size);
    at += 1 + size;
  }
}

/// True if the line has this code: `tenths` is ten times its number, 381 for G38.1.
inline bool has_code(std::string_view text, char letter, long tenths) {
  bool has = false;
  each_word(text, [&](char found, double value, std::size_t, std::size_t) {
    has = has || (found == letter && std::lround(value * 10) == tenths);
  });
  return has;
}

/// True if the controller writes its EEPROM at this line, during which it loses bytes (eeprom.c): G10, G28.1, G30.1.
inline bool writes_eeprom(std::string_view text) {
  return has_code(text, 'G', 100) || has_code(text, 'G', 281) || has_code(text, 'G', 301);
}

/// True for a probe motion: G38.2 to G38.5.
inline bool has_probe(std::string_view text) {
  return has_code(text, 'G', 382) || has_code(text, 'G', 383) || has_code(text, 'G', 384) || has_code(text, 'G', 385);
}

/// True if the line has a word for X, Y or Z.
inline bool has_axis_word(std::string_view text) { return text.find_first_of("XYZ") != std::string_view::npos; }

}  // namespace kadr::drive
