#pragma once
// The material of a part that spins around a place: how far it reaches towards the axis and away from it.

#include <optional>

#include "stock/stock.h"

namespace kadr {

/// Radii about X0 Y0, mm; `inner` is 0 where it reaches the axis.
struct RadiusRange {
  double inner, outer;
};

/// Of the lattice line along X that passes nearest to the axis at the height `z`, on the side of X+; nothing: no material is there.
std::optional<RadiusRange> material_around(const Stock& stock, double radius, double z);

}  // namespace kadr
