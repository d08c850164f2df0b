#pragma once
// LeanDivision: in which parts one brick takes the way of a tool that leans.
//
// A part must bend little there, for that is how far it is taken wrong; and no line of the brick may turn from one side of a flat face to
// the other within a part: beyond that it would be reached from both of its ends, and what lies between would be taken with them.

#include <array>

#include "stock/cut/lean_body.h"
#include "stock/cut/lean_cut.h"

namespace kadr {

/// mm: a place of the material is taken to be off its way past the tool by no more.
inline constexpr double bend_in_brick = 9e-4;

/// Shares of a way, ascending: parts go from one to the next.
struct LeanDivision {
  static constexpr int most_parts = 8;
  std::array<double, most_parts + 1> share{0, 1};
  int parts = 1;
};

/// Near the brick.
bool has_flat_face(const LeanSweep& sweep, const LeanBody& body);

/// `sweep`: the whole way, seen from the brick.
LeanDivision division_of(const LeanSweep& sweep, const LeanBody& body);

}  // namespace kadr
