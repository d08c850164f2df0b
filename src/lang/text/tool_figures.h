#pragma once
// Determines the meaning of each number in a comment, such as 10, 1/2 or .06; the code calls such a number a figure. "T2 1/2 BULL ENDMILL
// .06 RAD 4FL" has a tool number, an open number that may be the size of the tool, a corner radius and a count of flutes.

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "lang/text/tool_comment_tokens.h"
#include "lang/text/tool_words.h"

namespace kadr {

enum class FigureIs : std::uint8_t {
  open,          // the meaning is unknown: the number may be the size of the tool
  other,         // the number is not a size of the tool: a count, a length, a name, a second size, or a number without a known meaning
  tool,          // tool number: T1
  diameter,      // the number is a diameter, because a word of the comment says this: DIA 20
  corner,        // corner radius
  angle,         //
  metric,        // M8
  inch_thread,   // inch thread such as 1/4-20; `value` is the size, `threads` are per inch
  drill_number,  // #7, NO. 7
};

struct CommentPiece : CommentToken {
  ToolWordMeaning meaning;  // meaning of a word or sign
  FigureIs figure = FigureIs::open;
  double unit = 0;      // mm per unit for a number with a unit next to it; 0 without a unit
  double threads = 0;   // threads per inch of an inch_thread
  bool braced = false;  // the number is in braces, {6 mm}; a Vectric library writes the size into tool names in this form
  bool named = false;   // the number is a diameter after `=`, as CAM systems write it
  // Number of the clause; clauses are the parts of the comment that a vertical bar, comma, semicolon, colon or free dash separates.
  std::uint32_t clause = 0;
  bool of_another = false;  // the piece comes after FOR or WITH, so it describes another thing than the tool
  bool is_word() const { return is == Is::word; }
  bool is_figure() const { return is == Is::figure; }
  bool is_sign(char c) const { return is == Is::sign && text[0] == c; }
  bool is_open() const { return is_figure() && figure == FigureIs::open; }
};

/// Splits a comment into pieces and determines their meanings. `text`: UTF-8. A unit is merged into its number; a whole number and the
/// fraction after it become one number.
std::vector<CommentPiece> comment_pieces(std::string_view text);

}  // namespace kadr
