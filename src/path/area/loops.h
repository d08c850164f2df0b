#pragma once
// Loops: joins the edges of a drawing to closed contours. Outer contours counter-clockwise, islands clockwise: the zone is on the left.

#include "path/area/edge.h"

namespace kadr::area {

/// The joined edges.
struct Chains {
  std::vector<Edges> closed;
  std::vector<Edges> open;  // centre lines of slots
};

/// A connected area with its islands: loops[0] is the outer contour.
struct Zone {
  std::vector<Edges> loops;
};

/// Joins edges whose ends meet; ends up to tol::contour_gap apart are moved to the same point.
///   alarms  contour_branch
tl::expected<Chains, ContourFault> chained(const Edges& edges);

/// Returns the areas enclosed by the closed loops: outer contours with the loops directly inside them; a loop inside an island is a zone
/// again.
///   alarms  contour_open_end, if a chain does not close; contour_crosses
tl::expected<std::vector<Zone>, ContourFault> zones_of(const Chains& chains);

}  // namespace kadr::area
