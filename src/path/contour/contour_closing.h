#pragma once
// Where a programmed contour closes: the way along it comes back to where it has been. What lies before that place and after it, the
// run-in and the run-out, bounds no part: a square entered and left along the extensions of its sides, arcs that lead to a point of
// the contour and away from it, an end that goes on over the beginning.
//
//          run-in │                      the loop from the crossing to the crossing is the part's contour
//     ┌───────────┼──── … ───┐
//     └───────────┼──────────┘
//                 ╰ run-out

#include <cstdint>
#include <optional>
#include <span>

#include "path/curve/plane_distance.h"

namespace kadr {

/// The part's contour: from a place of one piece to a place of a later one.
struct ContourLoop {
  std::size_t first = 0;  // index of the piece in which it begins
  double first_part = 0;  // 0…1, how far along it
  std::size_t last = 0;   // … in which it ends
  double last_part = 1;
};

/// The loop of pieces that follow each other. `gap`: between the pieces before this index and those from it on lie others that are not
/// known; 0: none.
///   returns  nothing: it does not close, or what closes is less than a quarter of the whole
///   law      reversed: the same loop, reversed
std::optional<ContourLoop> closing(std::span<const PlanePiece> pieces, std::size_t gap);

/// The piece between two of its places, 0…1.
PlanePiece cut_out(const PlanePiece& piece, double from, double to);

}  // namespace kadr
