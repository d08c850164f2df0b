#pragma once
// StatedBox: the rectangular blank that a milling program states in its comments or by BLK FORM, and where it lies. It is used by
// view/stock_guess.

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "lang/text/box_comment.h"
#include "session/tool_proposals.h"
#include "stock/brick/lattice.h"

namespace kadr {

struct StatedBox {
  BoxComment size;
  std::uint32_t line = 0;  // the line that states the size
  std::string text;        // its comment
  // The cylinder of BLK FORM CYLINDER about Z: diameter, least and greatest Z, mm; `size` is the box around it
  std::optional<std::array<double, 3>> cylinder = {};
};

/// Returns the blank of BLK FORM (conversational programs), or the first one that the comments state; nullopt if none states a size.
///   inch  true: numbers without a unit are in inches
std::optional<StatedBox> stated_box(const ProgramLines& lines, bool inch);

/// Returns where the blank lies, mm from the program's zero. A comment states the size only, so the place is chosen by what is cut: along X
/// and Y the zero is in the middle of the blank or at one of its sides, whichever contains most of the cut; else the cut is in the middle.
/// Z0 is at the top if `top` is 0, at the bottom if only then the blank reaches from there to `top`.
///   cut    what the centres of the tools travel at feed, mm from the program's zero
///   top    Z of the top of the blank by the path, mm
/// If the sizes fit the cut only in another order (25X120X80), they are taken in that order.
Box3 placed_box(const BoxComment& stated, const Box3& cut, double top);

}  // namespace kadr
