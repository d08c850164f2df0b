#pragma once
// TiltedDivision: the parts into which the path of a tilted tool is divided for one brick.
//
// In each part, the points of the brick must move past the tool on nearly straight paths, because the bend of these paths is the error of
// the cut. Also, no lattice line of the brick may turn from one side of a flat face of the tool to the other: the face would reach the line
// from both ends of the line, and the material between the two positions would be removed too.

#include <array>

#include "stock/cut/tilted_body.h"
#include "stock/cut/tilted_cut.h"

namespace kadr {

/// Greatest permitted bend in mm. The bend is the greatest distance of the path of a material point, in the tool's coordinates, from the
/// chord of this path.
inline constexpr double bend_in_brick = 9e-4;

/// Fractions of a path (0 to 1) in ascending order; each part of the path is between one fraction and the next.
struct TiltedDivision {
  static constexpr int max_parts = 8;
  std::array<double, max_parts + 1> share{0, 1};
  int parts = 1;
};

/// Returns true if the body has a flat face near the brick.
bool has_flat_face(const TiltedSweep& sweep, const TiltedBody& body);

/// Returns the division for one brick. `sweep` is the whole path, as seen from this brick.
TiltedDivision division_of(const TiltedSweep& sweep, const TiltedBody& body);

}  // namespace kadr
