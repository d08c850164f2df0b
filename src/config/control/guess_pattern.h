#pragma once
// Patterns of [guess] in a control's file (texts that point to the control), and the lines in which these patterns are searched.

#include <cstdint>
#include <string>
#include <string_view>

namespace kadr {

/// A line of a program in the forms in which patterns are searched. All forms are in upper case.
struct GuessLine {
  std::string written;   // the line without comments, with one blank between words
  std::string squeezed;  // the line without comments, blanks and block number, and without leading zeros of G and M codes
  std::string raw;       // the line with its comments
  std::string comments;  // text in brackets and after `;`, or all of a line that starts with `# ` or `//`
};

/// Returns the forms of a line; all forms are empty if the line is empty.
GuessLine guess_line(std::string_view line);

/// Returns the first text in the line that the pattern matches; empty if the pattern does not match.
///   ^   the start of the line, after `/` and the block number     $   its end
///   \d  one or more digits     \c  one digit     \n  a number, with its sign or point     \a  the letter of an axis     \l  any letter
///   \*  any text or none, as short as possible     \\  any of these signs itself
/// A letter at the pattern's start matches only if no letter precedes it, a digit at its end only if no digit or fraction follows. A
/// pattern that starts with `(` or `;` is searched in comments, too; one with a blank in the words as written; all others without blanks.
std::string_view found_in(const GuessLine& line, std::string_view pattern);

/// Returns the first match of a pattern in a text without the structure of a block, such as the comments of a line. The rules are those of
/// found_in(). In addition, a letter at the pattern's end matches only if no letter follows it.
std::string_view found_in_words(std::string_view text, std::string_view pattern);

/// The set of characters that occur in a text, one bit for each character (some characters share a bit). A pattern that needs a character
/// outside this set cannot match the text.
using LineSigns = std::uint64_t;
LineSigns signs_of(std::string_view text);
LineSigns signs_needed(std::string_view pattern);
/// Returns the number of the bit, in `signs`, of the rarest character: of the characters in the set, the fewest lines of programs contain
/// it. Returns any_sign if the set is empty.
inline constexpr std::size_t any_sign = 64;
std::size_t rarest_sign(LineSigns signs);

/// Returns true if the path matches the pattern. The pattern is in lower case and may contain `*` and `?`.
///   path  must contain `/`; a pattern without `/` is compared only with the last component of the path
bool is_named_like(std::string_view path, std::string_view pattern);

}  // namespace kadr
