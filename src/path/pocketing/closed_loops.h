#pragma once
// This file joins the edges of a drawing to closed contours. Outer contours are counter-clockwise and islands clockwise, so the zone is on
// the left of each contour.

#include "path/pocketing/edge.h"

namespace kadr::area {

/// The joined edges of a drawing, as closed contours and open chains.
struct Chains {
  std::vector<Edges> closed;
  std::vector<Edges> open;  // centre lines of slots
};

/// A connected area with its islands: loops[0] is the outer contour.
struct Zone {
  std::vector<Edges> loops;
};

/// Joins edges whose end points meet. End points whose distance is at most tol::contour_gap are moved to the same point.
///   alarms  contour_branch
tl::expected<Chains, DrawingFault> chained(const Edges& edges);

/// Returns the areas that the closed loops enclose. Each area is an outer contour with the islands directly inside this contour. A loop
/// inside an island is the outer contour of a further zone.
///   alarms  contour_open_end, if a chain does not close; contour_crosses
tl::expected<std::vector<Zone>, DrawingFault> zones_of(const Chains& chains);

/// Returns the areas that lie within at least one of the closed loops `pockets` and within none of the closed loops `islands`, which may
/// cross each other. The loops may have either direction.
std::vector<Zone> zones_between(const std::vector<Edges>& pockets, const std::vector<Edges>& islands);

}  // namespace kadr::area
