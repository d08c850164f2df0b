#pragma once
// StatedBlank: the blank of a turned part, as the comments of the program and the path of the tools tell it. It is used by cli/cut_guess
// and view/page.

#include <cstdint>
#include <optional>
#include <string>

#include "lang/text/stock_comment.h"
#include "session/tool_proposals.h"

namespace kadr {

struct StatedBlank {
  StockComment size;       // `diameter` is known
  std::uint32_t line = 0;  // the line that states the diameter
  std::string text;        // its comment
};

/// Returns the blank that the comments state; nullopt if none states a diameter. Sizes that its comment does not state are taken from other
/// comments about the blank.
///   inch  true: numbers without a unit are in inches
std::optional<StatedBlank> stated_blank(const ProgramLines& lines, bool inch);

/// What else than the path tells the blank of a turned part.
struct TurnedHints {
  std::optional<StatedBlank> stated;
  std::optional<double> chuck_face;  // Z, mm; the jaws grip the blank below it
};

/// What the tools sweep at feed, mm: the greatest radius, and the least and greatest Z.
struct TurnedExtents {
  double radius = 0, bottom = 0, top = 0;
};

/// Returns the text of the blank for `--stock`: a cylinder about the axis.
///   diameter  the stated one; else that of the path, rounded up to whole mm
///   top       1 mm above Z0 if the path goes from below Z0 to above it (the face is cut); else the top of the path
///   bottom    the stated length below the top; else `margin` below the path and at least 20 mm below the face of the chuck, rounded down
///   to
///             whole mm
std::string turned_blank_text(const TurnedHints& hints, const TurnedExtents& path, double margin);

}  // namespace kadr
