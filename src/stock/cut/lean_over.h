#pragma once
// LeanOver: lines that a turning surface may turn over.
//
// Where a line all but lies in the side of a tool (in a cone, or in a rounded edge close to a flat face) and the tool turns, what it sweeps
// of the line need not be an interval: the surface may come to the line from both of its ends, and never to what lies between. Of a place s
// of the line and a moment t, in both of which the surface lies by
//
//   d = a + b t + (c + w t) s + k s² / 2      w: the turn; k: how much the surface is bent along the line
//
// off the line, that happens only where the line is met at both ends of the way and the two intervals are apart; what lies between them is
// off by at most turn · (what is between) / 4 and at most turn² / 8k. Such lines are left for later: for the halves of the way, until
// nothing is apart that counts.
//
// Flat faces are not asked for: a brick divides the way where one of them turns over its lines (lean_division.h).

#include <cstdint>

#include "stock/brick/brick.h"
#include "stock/cut/lean_body.h"
#include "stock/cut/lean_cut.h"

namespace kadr {

/// mm: what is let pass of what lies between.
inline constexpr float over_allowed = 2e-4f;

/// Which lines of which families are looked at so closely: most are bent so much that nothing can come of it.
struct LeanOver {
  LeanOver() = default;
  LeanOver(const LeanSweep& sweep, const LeanBody& body, float edge);

  struct Family {
    bool by_end = false, by_shaft = false, by_edge = false, by_face = false;  // the parts of the body in which lines may all but lie
    bool any() const { return by_end || by_shaft || by_edge || by_face; }
  };
  Family family[3];
  float apart = 0;       // mm of line that may lie between
  float edge_below = 0;  // height above the tip below which a rounded edge is as flat
};

}  // namespace kadr
