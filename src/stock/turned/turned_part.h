#pragma once
// Compares a turned part with the wanted part, exactly, as regions of the half plane. It is used by cli/cut_turned.

#include <optional>

#include "stock/mesh/mesh.h"
#include "stock/turned/turned_stock.h"

namespace kadr {

/// Returns the region of the half plane that a mesh of a body of revolution about Z encloses; nullopt if the mesh is no such body.
///   tolerance  greatest distance of a corner of the mesh from the surface of the returned body, mm
///   law        the section of turned_mesh(region) is the region, within the deviation of the mesh   (tests/stock/turned_part_test)
std::optional<TurnedRegion> section_of(const Mesh& mesh, double tolerance);

/// What one body has beyond the other.
struct TurnedDifference {
  double volume = 0;   // mm³
  double deepest = 0;  // greatest distance from the surface of the wanted part, mm
  Vec2 at;             // position of this distance: radius, Z
};

struct TurnedComparison {
  TurnedDifference left_on;  // material outside the wanted part
  TurnedDifference gouged;   // wanted part without material
};

/// Compares a part with the wanted part. What is nowhere farther from the surface of the wanted part than 0.002 mm is rounding and does not
/// count, as on the lattice.
TurnedComparison compare(const TurnedRegion& part, const TurnedRegion& wanted);

/// Returns the signed distance of a point from the surface of the wanted part, mm: positive outside the part.
double distance_from(const TurnedRegion& wanted, Vec2 at);

}  // namespace kadr
