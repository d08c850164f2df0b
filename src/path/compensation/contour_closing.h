#pragma once
// This file finds the point at which a programmed contour closes, that is, returns to an earlier point. The path before the closed loop
// (run-in) and the path after the loop (run-out) do not bound the workpiece. Examples are a square that is entered and left along the
// extensions of its sides, arcs that lead to a point of the contour and away from this point, and an end that overlaps the start.
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

/// The workpiece contour. It starts within one piece of the path and ends within a later piece.
struct ContourLoop {
  std::size_t first = 0;  // index of the piece in which the loop starts
  double first_part = 0;  // fraction (0 to 1) of the length of the piece `first` at which the loop starts
  std::size_t last = 0;   // index of the piece in which the loop ends
  double last_part = 1;   // fraction (0 to 1) of the length of the piece `last` at which the loop ends
};

/// Returns the closed loop of consecutive pieces. If `gap` is not 0, pieces are missing from the list between the indices gap − 1 and gap.
///   returns  nullopt if the contour does not close, or the loop is shorter than a quarter of the whole path
///   law      the reversed list of pieces gives the same loop in the reversed direction
std::optional<ContourLoop> closing(std::span<const PlanePiece> pieces, std::size_t gap);

/// Returns the section of a piece between two fractions, 0 to 1, of its length.
PlanePiece cut_out(const PlanePiece& piece, double from, double to);

}  // namespace kadr
