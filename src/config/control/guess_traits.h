#pragma once
// Traits of a program's text as a whole, found without regard to any control: block numbers, decimal points, letters in use.

#include <cstdint>
#include <string>
#include <string_view>

#include "config/text_id.h"

namespace kadr {

enum class TextTrait : std::uint8_t {
  all_numbered,     // every block of the text has a block number
  few_numbered,     // less than half of the blocks of the text have a block number
  decimal_points,   // at least one number has a decimal point
  trailing_points,  // `X10.`: some numbers end with the decimal point, without a digit after it
  long_integers,    // coordinates have four or more digits, and no coordinate has a decimal point
  whole_lengths,    // X10, Y-5: coordinates have one to three digits, and no coordinate has a decimal point
  plus_signs,       // `X+10.`: numbers have plus signs, and no code has a single digit
  two_digit_codes,  // all codes have two digits, as G01 has, and every block has a block number
  // A line with `%` is followed by a program number such as O0001; not set if all blocks are numbered and all codes have two digits
  program_number,
  percent,          // the text starts with `%`
  no_percent,       // the text has no `%`
  no_tools,         // the text contains no T word, no M6 and no H word
  without_y,        // the text contains X and Z words, but no Y word
  u_w_words,        // the text contains U or W words, but no A, B, C or Y word
  changing_power,   // the text contains at least three S words in blocks without M3, M4 or T
  feed_everywhere,  // most feed motions have an F word in their block
  count
};

/// The key of a trait in [guess.text], and its text for people.
struct TraitText {
  std::string_view key;
  PlainText text;
};
const TraitText& text_of(TextTrait trait);

/// Collects the traits of a text. It receives the lines of the text one by one, in upper case and without comments.
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
