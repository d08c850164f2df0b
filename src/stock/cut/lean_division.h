#pragma once
// LeanDivision: the parts into which one brick divides the path of a tilted tool.
//
// The path of a part must bend little in the brick, since the bend is its error. And no line of the brick may turn from one side of a
// flat face to the other within a part: the face would then reach it from both of its ends, and what lies between would be removed
// too.

#include <array>

#include "stock/cut/lean_body.h"
#include "stock/cut/lean_cut.h"

namespace kadr {

/// mm: greatest assumed distance of a material point from its path past the tool.
inline constexpr double bend_in_brick = 9e-4;

/// Shares of a path in ascending order; each part goes from one to the next.
struct LeanDivision {
  static constexpr int most_parts = 8;
  std::array<double, most_parts + 1> share{0, 1};
  int parts = 1;
};

/// True if the body has a flat face near the brick.
bool has_flat_face(const LeanSweep& sweep, const LeanBody& body);

/// `sweep` is the whole path, seen from the brick.
LeanDivision division_of(const LeanSweep& sweep, const LeanBody& body);

}  // namespace kadr
