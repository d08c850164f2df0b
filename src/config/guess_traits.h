#pragma once
// What a text is like as a whole, before anybody asks for which control: block numbers, decimal points, which letters are used.

#include <cstdint>
#include <string>
#include <string_view>

namespace kadr {

enum class TextTrait : std::uint8_t {
  all_numbered,     // every block has its number
  few_numbered,     // less than half
  decimal_points,   // some number has one
  trailing_points,  // `X10.`: nothing behind the point
  long_integers,    // coordinates of four digits and more, and no point anywhere
  whole_lengths,    // X10, Y-5: of one to three digits, and no length has a point
  plus_signs,       // `X+10.`, and no code of one digit
  two_digit_codes,  // G01, and no code of one digit; every block numbered
  program_number,   // `%`, then O0001; not where every block is numbered, with codes of two digits only
  percent,          // `%` stands at the beginning
  no_percent,       // no `%` anywhere
  no_tools,         // no T, no M6, no H
  without_y,        // X and Z are programmed, Y never
  u_w_words,        // U or W, and no A, B, C, Y
  changing_power,   // S by itself, three times and more, with neither M3, M4 nor T in its block
  feed_everywhere,  // most feed motions name their F
  count
};

/// As the keys of [guess.text] say it; and for people.
struct TraitText {
  std::string_view key, en, ru;
};
const TraitText& text_of(TextTrait trait);

/// Takes the lines of a text one by one, in capitals, without their comments.
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
