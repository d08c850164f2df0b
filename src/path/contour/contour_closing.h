#pragma once
// Where a programmed contour closes: where its path returns to an earlier point. What lies before and after the closed loop, the run-in
// and the run-out, does not bound the part: a square entered and left along the extensions of its sides, arcs that lead to a point of the
// contour and away from it, an end that continues over the start.
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

/// The part's contour: from a position in one piece to a position in a later one.
struct ContourLoop {
  std::size_t first = 0;  // index of the piece in which it starts
  double first_part = 0;  // 0…1, how far along this piece
  std::size_t last = 0;   // index of the piece in which it ends
  double last_part = 1;
};

/// Returns the closed loop of consecutive pieces. `gap`: between the pieces before this index and those from it on, other pieces are
/// missing; 0: none are missing.
///   returns  nullopt if the contour does not close, or the loop is less than a quarter of the whole
///   law      reversed pieces give the same loop, reversed
std::optional<ContourLoop> closing(std::span<const PlanePiece> pieces, std::size_t gap);

/// Returns the part of a piece between two positions, 0…1.
PlanePiece cut_out(const PlanePiece& piece, double from, double to);

}  // namespace kadr
