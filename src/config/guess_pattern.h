#pragma once
// A piece of text that speaks for a control, as a row of [guess] in its file writes it, and lines in which it is looked for.

#include <string>
#include <string_view>

namespace kadr {

/// A line in the three forms that patterns are looked for in; all in capitals.
struct GuessLine {
  std::string written;   // comments left out, blanks between words one
  std::string squeezed;  // without blanks, block number and leading zeros of G, M
  std::string raw;       // with its comments
};

/// Empty forms where the line holds nothing.
GuessLine guess_line(std::string_view line);

/// The first place of the pattern, as the text writes it; empty: it is not there.
///   ^   the beginning of the line, behind `/` and the block number     $   its end
///   \d  a digit or several     \c  one digit     \n  a number, with its sign or point     \a  a letter of an axis     \\  any of these
///   signs itself else the character. A letter at the beginning stands behind no letter, a digit at the end before no digit or fraction.
/// A pattern with `(` or `;` first is looked for in comments, too; one with a blank in the words as written; all others without blanks.
std::string_view found_in(const GuessLine& line, std::string_view pattern);

}  // namespace kadr
