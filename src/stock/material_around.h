#pragma once
// Measures the material of a spinning part near a given point: how far it reaches towards the axis and away from it.

#include <optional>

#include "stock/stock.h"

namespace kadr {

/// Radii about X0 Y0, mm; `inner` is 0 where the material reaches the axis.
struct RadiusRange {
  double inner, outer;
};

/// Returns the radii of the piece of material at `radius` on the lattice line along X that passes nearest to the axis at the height
/// `z`, on its X+ side. Returns nullopt if there is no material.
std::optional<RadiusRange> material_around(const Stock& stock, double radius, double z);

}  // namespace kadr
