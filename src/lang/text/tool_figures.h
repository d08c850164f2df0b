#pragma once
// What each figure of a comment is: "T2 1/2 BULL ENDMILL .06 RAD 4FL" has a tool's number, an open figure that may be the size, a corner
// and a count.

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "lang/text/tool_comment_tokens.h"
#include "lang/text/tool_words.h"

namespace kadr {

enum class FigureIs : std::uint8_t {
  open,          // nothing says: it may be the size of the tool
  other,         // something else: a count, a length, a name, a second size, what is not understood
  tool,          // its number: T1
  diameter,      // called so
  corner,        // radius
  angle,         //
  metric,        // M8
  inch_thread,   // 1/4-20; `value` is the size, `threads` an inch
  drill_number,  // #7, NO. 7
};

struct CommentPiece : CommentToken {
  ToolWordMeaning meaning;  // of a word or sign
  FigureIs figure = FigureIs::open;
  double unit = 0;           // of a figure: mm of its unit, as written beside it; 0: none is
  double threads = 0;        // of inch_thread
  bool braced = false;       // {6 mm}: the name of a tool in a library of Vectric's has its size so
  bool named = false;        // of a diameter: behind `=`, as CAM systems write it
  std::uint32_t clause = 0;  // what stands between two of | , ; : and a free dash
  bool of_another = false;   // behind FOR, WITH: it is said of another thing
  bool is_word() const { return is == Is::word; }
  bool is_figure() const { return is == Is::figure; }
  bool is_sign(char c) const { return is == Is::sign && text[0] == c; }
  bool is_open() const { return is_figure() && figure == FigureIs::open; }
};

/// `text`: UTF-8. Units are taken into their figures, a whole number and its fraction are one figure.
std::vector<CommentPiece> comment_pieces(std::string_view text);

}  // namespace kadr
