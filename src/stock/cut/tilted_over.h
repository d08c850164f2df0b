#pragma once
// TiltedOver: finds lattice lines over which the surface of a tilted tool may turn during a sweep.
//
// A lattice line may nearly lie in the surface of a tool: in a cone, or in a corner radius close to a flat face. If the tool turns, it may
// then sweep two separate intervals of the line: the surface reaches the line from both ends, and never the part between. Near such a line
// let d (mm) be the distance of the surface from the point at s (mm) on the line, when the tool is at the fraction t (0 to 1) of the path:
//
//   d = a + b t + (c + w t) s + k s² / 2      w: turn of the tool, radians; k: curvature of the surface along the line, 1/mm;
//                                             a, b, c: coefficients
//
// According to this formula, two intervals occur only if the tool meets the line in both end poses of the path, in two separate intervals.
// If the part between the intervals is removed too, the error is at most turn · (length between) / 4, and at most turn² / 8k. Lines with a
// greater error are cut with the two halves of the path instead, repeatedly, until every error is small enough.
//
// Flat faces are not treated here: TiltedDivision divides the path where a flat face turns over lines of the brick (tilted_division.h).

#include <cstdint>

#include "stock/brick/brick.h"
#include "stock/cut/tilted_body.h"
#include "stock/cut/tilted_cut.h"

namespace kadr {

/// Accepted error in mm where the part of a line between two swept intervals is removed too.
inline constexpr float over_allowed = 2e-4f;

/// The families of lattice lines for which a cut must check whether the tool's surface turns over lines. Usually the curvature of the
/// surface is so great that no check is needed.
struct TiltedOver {
  TiltedOver() = default;
  TiltedOver(const TiltedSweep& sweep, const TiltedBody& body, float edge);

  struct Family {
    // Surfaces of the body in which lines of the family may nearly lie.
    bool by_end = false, by_shaft = false, by_edge = false, by_face = false;
    bool any() const { return by_end || by_shaft || by_edge || by_face; }
  };
  Family family[3];
  float apart = 0;  // greatest accepted gap in mm between the two swept intervals of a line
  // Height above the tip, mm; only below this height is the corner radius so flat that a line may nearly lie in its surface.
  float edge_below = 0;
};

}  // namespace kadr
