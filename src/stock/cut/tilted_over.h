#pragma once
// TiltedOver: finds lattice lines over which the surface of a tilted tool may turn during a sweep.
//
// If a line nearly lies in the surface of a tool (in a cone, or in a rounded edge close to a flat face) and the tool turns, the tool may
// sweep two separate intervals of the line: its surface reaches the line from both ends, and never what lies between. Near such a line
// let d (mm) be the distance of the surface from the point at s (mm) on the line, at the share t (0 to 1) of the path:
//
//   d = a + b t + (c + w t) s + k s² / 2      w: turn of the tool, radians; k: curvature of the surface along the line, 1/mm;
//                                             a, b, c: coefficients
//
// Then two intervals occur only if the line is met in both end poses of the path and these two intervals are apart. If what lies
// between is removed too, the error is at most turn · (length between) / 4, and at most turn² / 8k. Lines with a greater error are cut
// with the two halves of the path instead, repeatedly, until no gap matters.
//
// Flat faces are not treated here: TiltedDivision divides the path where a flat face turns over lines of the brick (tilted_division.h).

#include <cstdint>

#include "stock/brick/brick.h"
#include "stock/cut/tilted_body.h"
#include "stock/cut/tilted_cut.h"

namespace kadr {

/// mm, accepted error of removing what lies between two intervals
inline constexpr float over_allowed = 2e-4f;

/// The families of lines that need this check. Usually the curvature k is so great that no error can result.
struct TiltedOver {
  TiltedOver() = default;
  TiltedOver(const TiltedSweep& sweep, const TiltedBody& body, float edge);

  struct Family {
    bool by_end = false, by_shaft = false, by_edge = false, by_face = false;  // parts of the body in whose surface lines may nearly lie
    bool any() const { return by_end || by_shaft || by_edge || by_face; }
  };
  Family family[3];
  float apart = 0;       // mm: the two intervals of a line may be this far apart
  float edge_below = 0;  // height above the tip, mm: only below this height the rounded edge is so flat that lines may nearly lie in it
};

}  // namespace kadr
