#pragma once
// Traits of a text as a whole, found before any control is considered: block numbers, decimal points, letters in use.

#include <cstdint>
#include <string>
#include <string_view>

namespace kadr {

enum class TextTrait : std::uint8_t {
  all_numbered,     // every block has a number
  few_numbered,     // less than half of the blocks have one
  decimal_points,   // some number has a point
  trailing_points,  // `X10.`: no digit after the point
  long_integers,    // coordinates of four or more digits, and no point anywhere
  whole_lengths,    // X10, Y-5: one to three digits, and no length has a point
  plus_signs,       // `X+10.`, and no code of one digit
  two_digit_codes,  // G01, no code of one digit, every block numbered
  program_number,   // `%`, then O0001; does not count if all blocks are numbered and all codes have two digits
  percent,          // `%` is at the start
  no_percent,       // no `%` anywhere
  no_tools,         // no T, no M6, no H
  without_y,        // X and Z are used, Y never
  u_w_words,        // U or W is used, and A, B, C, Y are not
  changing_power,   // S alone, without M3, M4 or T in its block, at least three times
  feed_everywhere,  // most feed motions have an F
  count
};

/// The key of a trait in [guess.text], and its texts for people.
struct TraitText {
  std::string_view key, en, ru;
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

  bool any_ = false, percent_first_ = false, percent_ = false, behind_percent_ = false, numbered_program_ = false;
  bool tools_ = false, x_ = false, y_ = false, z_ = false, u_or_w_ = false, rotary_ = false;
  std::uint64_t lines_ = 0, numbered_ = 0, points_ = 0, trailing_points_ = 0, two_digit_codes_ = 0, one_digit_codes_ = 0, plus_signs_ = 0;
  std::uint64_t long_integers_ = 0, short_lengths_ = 0, pointed_lengths_ = 0, powers_ = 0, feed_motions_ = 0, feeds_ = 0;
};

}  // namespace kadr
