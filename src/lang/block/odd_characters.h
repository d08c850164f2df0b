#pragma once
// Characters that are not part of a word: the alarm for each of them, and functions that count characters. Used by the lexer.

#include <algorithm>
#include <string_view>

#include "lang/block/block.h"
#include "lang/expression/expression.h"

namespace kadr {

/// Returns the alarm for the character at the offset `at`, which cannot be the start of a word or comment.
inline Alarm unexpected_at(std::string_view text, std::size_t at) {
  const auto c = static_cast<unsigned char>(text[at]);
  const Span where{static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(std::min(at + 1, text.size()))};
  if (c < 0x20) return alarm(AlarmId::control_character, where, double(c));
  if (c == '.') return alarm(AlarmId::number_damaged, where);  // a point outside a word is the second decimal point of a number
  return alarm(AlarmId::unexpected_character, where, text[at]);
}

/// Accepts Ctrl-Z at the end of the text and moves the cursor after it. Returns false if other characters follow.
inline bool passes_dos_end(Cursor& cursor) {
  Cursor after = cursor;
  ++after.at;
  after.skip_blanks();
  if (after.at < after.text.size()) return false;
  cursor = after;
  return true;
}

/// Returns the number of characters in a UTF-8 text.
inline std::uint32_t characters_of(std::string_view text) {
  return static_cast<std::uint32_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// Returns true if the text has bytes above 127.
inline bool has_high_bytes(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0x80) != 0; });
}

}  // namespace kadr
