#pragma once
// Chooses the corners that a polygon of the half plane needs to stay within a deviation. It is used by stock/turned.

#include <vector>

#include "stock/turned/insert_sweep.h"

namespace kadr {

/// Returns for each corner of a closed polygon whether it is needed (Douglas, Peucker 1973).
///   fixed      for each corner whether it must stay; may be empty
///   deviation  greatest distance of the left out corners from the lines between the needed ones, mm
///   returns    true for at least two corners
std::vector<bool> needed_corners(const TurnedPolygon& polygon, const std::vector<bool>& fixed, double deviation);

}  // namespace kadr
