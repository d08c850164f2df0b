#pragma once
// What speaks for each control: the section [guess] of the controls' files.

#include <toml++/toml.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace kadr {

/// What a text is like as a whole.
enum class TextTrait : std::uint8_t {
  all_numbered,     // every block has its number
  few_numbered,     // less than half
  decimal_points,   // some number has one
  long_integers,    // coordinates of four digits and more, and no point anywhere
  whole_lengths,    // X10, Y-5: of one to three digits, and no length has a point
  plus_signs,       // `X+10.`, and no code of one digit
  two_digit_codes,  // G01, and no code of one digit; every block numbered
  program_number,   // `%`, then O0001; not where every block is numbered, with codes of two digits only
  count
};
/// As the keys of [guess.text] say it; and for people.
struct TraitText {
  std::string_view key, en, ru;
};
const TraitText& text_of(TextTrait trait);

struct GuessMark {
  std::string pattern;  // guess_pattern.h
  double weight = 0;
};

/// Of one control.
struct GuessRows {
  std::string control;
  std::vector<GuessMark> marks;
  std::vector<std::pair<TextTrait, double>> traits;
};

/// A mark of this weight tells the control by itself.
inline constexpr double decisive_weight = 10;

/// Rows of a section [guess].
///   returns  an error sentence: a weight that is no number from 0 to 20, a trait that nobody knows
tl::expected<GuessRows, std::string> guess_rows_of(const toml::table& guess, const std::string& file);

/// Of the built-in controls, read once.
const std::vector<GuessRows>& built_in_guess_rows();

}  // namespace kadr
