#pragma once
// Determines the meaning of each figure in a comment: "T2 1/2 BULL ENDMILL .06 RAD 4FL" has a tool number, an open figure that may be
// the size, a corner radius and a count.

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "lang/text/tool_comment_tokens.h"
#include "lang/text/tool_words.h"

namespace kadr {

enum class FigureIs : std::uint8_t {
  open,          // unknown: it may be the size of the tool
  other,         // something else: a count, a length, a name, a second size, or not understood
  tool,          // tool number: T1
  diameter,      // called diameter
  corner,        // corner radius
  angle,         //
  metric,        // M8
  inch_thread,   // 1/4-20; `value` is the size, `threads` are per inch
  drill_number,  // #7, NO. 7
};

struct CommentPiece : CommentToken {
  ToolWordMeaning meaning;  // for a word or sign
  FigureIs figure = FigureIs::open;
  double unit = 0;           // for a figure: mm per unit if one is written next to it; else 0
  double threads = 0;        // for an inch_thread
  bool braced = false;       // {6 mm}: the form of the size in the tool names of a Vectric library
  bool named = false;        // a diameter after `=`, as CAM systems write it
  std::uint32_t clause = 0;  // number of the part between two of | , ; : and a free dash
  bool of_another = false;   // after FOR, WITH: it describes another thing
  bool is_word() const { return is == Is::word; }
  bool is_figure() const { return is == Is::figure; }
  bool is_sign(char c) const { return is == Is::sign && text[0] == c; }
  bool is_open() const { return is_figure() && figure == FigureIs::open; }
};

/// `text`: UTF-8. Units are merged into their figures; a whole number and its fraction become one figure.
std::vector<CommentPiece> comment_pieces(std::string_view text);

}  // namespace kadr
