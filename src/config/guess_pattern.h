#pragma once
// A piece of text that speaks for a control, as a row of [guess] in its file writes it, and lines in which it is looked for.

#include <cstdint>
#include <string>
#include <string_view>

namespace kadr {

/// A line in the forms that patterns are looked for in; all in capitals.
struct GuessLine {
  std::string written;   // comments left out, blanks between words one
  std::string squeezed;  // without blanks, block number and leading zeros of G, M
  std::string raw;       // with its comments
  std::string comments;  // what stands in brackets and behind `;`, or all of a line behind `#` and a blank, `//`
};

/// Empty forms where the line holds nothing.
GuessLine guess_line(std::string_view line);

/// The first place of the pattern, as the text writes it; empty: it is not there.
///   ^   the beginning of the line, behind `/` and the block number     $   its end
///   \d  a digit or several     \c  one digit     \n  a number, with its sign or point     \a  a letter of an axis     \l  any letter
///   \*  anything or nothing, as little as will do     \\  any of these signs itself
/// A letter at the beginning stands behind no letter, a digit at the end before no digit or fraction.
/// A pattern with `(` or `;` first is looked for in comments, too; one with a blank in the words as written; all others without blanks.
std::string_view found_in(const GuessLine& line, std::string_view pattern);

/// The same in a text of its own, such as the comments of a line; there a letter at the end stands before no letter.
std::string_view found_in_words(std::string_view text, std::string_view pattern);

/// Which signs stand in a text, a bit each (some share one): a pattern that needs others need not be looked for.
using LineSigns = std::uint64_t;
LineSigns signs_of(std::string_view text);
LineSigns signs_needed(std::string_view pattern);
/// Which of them, by its bit, the fewest lines of programs have; any_sign: there is none.
inline constexpr std::size_t any_sign = 64;
std::size_t rarest_sign(LineSigns signs);

/// `*`, `?` of file names, in small letters.
///   path  with `/`; a pattern without one is held against the last part of the path alone
bool is_named_like(std::string_view path, std::string_view pattern);

}  // namespace kadr
