#pragma once
// LeanOver: finds lines that a turning surface may turn over.
//
// If a line nearly lies in the side of a tool (in a cone, or in a rounded edge close to a flat face) and the tool turns, what it
// sweeps of the line need not be an interval: the surface may reach the line from both of its ends, and never what lies between. Let
// the distance of the surface from the line, at a position s of the line and a time t, be
//
//   d = a + b t + (c + w t) s + k s² / 2      w: the turn; k: the curvature of the surface along the line
//
// Then this happens only if the line is met at both ends of the path and the two intervals are apart. What lies between them is off
// by at most turn · (length between) / 4 and at most turn² / 8k. Such lines are left for the halves of the path, until no gap
// matters.
//
// Flat faces are not treated here: a brick divides the path where one of them turns over its lines (lean_division.h).

#include <cstdint>

#include "stock/brick/brick.h"
#include "stock/cut/lean_body.h"
#include "stock/cut/lean_cut.h"

namespace kadr {

/// mm: accepted error of what lies between.
inline constexpr float over_allowed = 2e-4f;

/// The lines of each family that need this check: in most cases the curvature is so great that no error can result.
struct LeanOver {
  LeanOver() = default;
  LeanOver(const LeanSweep& sweep, const LeanBody& body, float edge);

  struct Family {
    bool by_end = false, by_shaft = false, by_edge = false, by_face = false;  // parts of the body in which lines may nearly lie
    bool any() const { return by_end || by_shaft || by_edge || by_face; }
  };
  Family family[3];
  float apart = 0;       // mm of line that may lie between the intervals
  float edge_below = 0;  // height above the tip below which a rounded edge is this flat
};

}  // namespace kadr
