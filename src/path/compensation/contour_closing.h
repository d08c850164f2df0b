#pragma once
// Finds where a programmed contour closes, that is, returns to an earlier point. The path before the closed loop (run-in) and after it
// (run-out) does not bound the workpiece. Examples: a square entered and left along the extensions of its sides, arcs that lead to a
// point of the contour and away from it, an end that overlaps the start.
//
//          run-in │                      the loop that starts and ends at the crossing is the workpiece contour
//     ┌───────────┼──── … ───┐
//     └───────────┼──────────┘
//                 ╰ run-out

#include <cstdint>
#include <optional>
#include <span>

#include "path/curve/plane_distance.h"

namespace kadr {

/// The workpiece contour: it starts within one piece of the path and ends within a later piece.
struct ContourLoop {
  std::size_t first = 0;  // index of the piece in which the loop starts
  double first_part = 0;  // fraction of the length of piece `first` at which the loop starts, 0 … 1
  std::size_t last = 0;   // index of the piece in which the loop ends
  double last_part = 1;   // fraction of the length of piece `last` at which the loop ends, 0 … 1
};

/// Returns the closed loop of consecutive pieces. `gap`: pieces are missing from the list between the indices gap − 1 and `gap`; 0: no
/// pieces are missing.
///   returns  nullopt if the contour does not close, or the loop is shorter than a quarter of the whole path
///   law      reversed pieces give the same loop, reversed
std::optional<ContourLoop> closing(std::span<const PlanePiece> pieces, std::size_t gap);

/// Returns the section of a piece between two fractions of its length, 0 … 1.
PlanePiece cut_out(const PlanePiece& piece, double from, double to);

}  // namespace kadr
