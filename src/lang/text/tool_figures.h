#pragma once
// Determines the meaning of each figure (number, such as 10, 1/2 or .06) in a comment: "T2 1/2 BULL ENDMILL .06 RAD 4FL" has a tool
// number, an open figure that may be the size of the tool, a corner radius and a count of flutes.

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "lang/text/tool_comment_tokens.h"
#include "lang/text/tool_words.h"

namespace kadr {

enum class FigureIs : std::uint8_t {
  open,          // unknown: the figure may be the size of the tool
  other,         // not a size of the tool: a count, a length, a name, a second size, or a figure without a known meaning
  tool,          // tool number: T1
  diameter,      // a diameter, because a word of the comment says so: DIA 20
  corner,        // corner radius
  angle,         //
  metric,        // M8
  inch_thread,   // 1/4-20; `value` is the size, `threads` are per inch
  drill_number,  // #7, NO. 7
};

struct CommentPiece : CommentToken {
  ToolWordMeaning meaning;  // meaning of a word or sign
  FigureIs figure = FigureIs::open;
  double unit = 0;           // for a figure with a unit next to it: mm per unit; else 0
  double threads = 0;        // for an inch_thread
  bool braced = false;       // the figure is in braces, {6 mm}, as a Vectric library writes the size in tool names
  bool named = false;        // a diameter after `=`, as CAM systems write it
  std::uint32_t clause = 0;  // number of the clause, which is the part of the comment between two of | , ; : or free dashes
  bool of_another = false;   // the piece comes after FOR or WITH, so it describes another thing, not the tool
  bool is_word() const { return is == Is::word; }
  bool is_figure() const { return is == Is::figure; }
  bool is_sign(char c) const { return is == Is::sign && text[0] == c; }
  bool is_open() const { return is_figure() && figure == FigureIs::open; }
};

/// Splits a comment into pieces and determines their meanings. `text`: UTF-8. A unit is merged into its figure; a whole number and the
/// fraction after it become one figure.
std::vector<CommentPiece> comment_pieces(std::string_view text);

}  // namespace kadr
