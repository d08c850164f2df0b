#pragma once
// Measures the material of a spinning part near a given point: finds the radii between which there is material.

#include <optional>

#include "stock/stock.h"

namespace kadr {

/// Radii about the axis X0 Y0, mm; `inner` is 0 where the material reaches the axis.
struct RadiusRange {
  double inner, outer;
};

/// Returns the inner and outer radius of the connected material that contains `radius` at the height `z`. The material is measured on the
/// X+ side of the part, on the lattice line along X that passes nearest to the axis. Returns nullopt if there is no material at `radius`.
std::optional<RadiusRange> material_around(const Stock& stock, double radius, double z);

}  // namespace kadr
