#pragma once
// Traits of a text as a whole, found before any control is considered: block numbers, decimal points, letters in use.

#include <cstdint>
#include <string>
#include <string_view>

#include "config/text_id.h"

namespace kadr {

enum class TextTrait : std::uint8_t {
  all_numbered,     // every block has a number
  few_numbered,     // less than half of the blocks have a number
  decimal_points,   // some number has a decimal point
  trailing_points,  // `X10.`: numbers without a digit after the decimal point
  long_integers,    // coordinates of four or more digits, and no decimal point anywhere
  whole_lengths,    // X10, Y-5: coordinates of one to three digits, and no coordinate has a decimal point
  plus_signs,       // `X+10.`: plus signs are written, and no code has one digit
  two_digit_codes,  // G01: codes have two digits, none has one, and every block is numbered
  program_number,   // `%`, then a program number such as O0001; does not count if all blocks are numbered and all codes have two digits
  percent,          // the text starts with `%`
  no_percent,       // the text has no `%`
  no_tools,         // the text has no T, no M6, no H
  without_y,        // X and Z are used, Y never
  u_w_words,        // U or W is used, and A, B, C, Y are not
  changing_power,   // S in blocks without M3, M4 or T, at least three times
  feed_everywhere,  // most feed motions have an F
  count
};

/// The key of a trait in [guess.text], and its text for people.
struct TraitText {
  std::string_view key;
  PlainText text;
};
const TraitText& text_of(TextTrait trait);

/// Collects the traits of a text, whose lines it receives one by one, in upper case and without comments.
class Traits {
 public:
  void take(std::string_view line);
  bool holds(TextTrait trait) const;

 private:
  void letter(std::string_view line, std::size_t i);
  void length(std::string_view line, std::size_t at, bool of_axis);
  void feed_and_power(std::string_view line);

  bool any_ = false, percent_first_ = false, percent_ = false, after_percent_ = false, numbered_program_ = false;
  bool tools_ = false, x_ = false, y_ = false, z_ = false, u_or_w_ = false, rotary_ = false;
  std::uint64_t lines_ = 0, numbered_ = 0, points_ = 0, trailing_points_ = 0, two_digit_codes_ = 0, one_digit_codes_ = 0, plus_signs_ = 0;
  std::uint64_t long_integers_ = 0, short_lengths_ = 0, pointed_lengths_ = 0, powers_ = 0, feed_motions_ = 0, feeds_ = 0;
};

}  // namespace kadr
