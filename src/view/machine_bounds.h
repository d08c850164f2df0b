#pragma once
// machine_bounds: the travel limits of the machine's axes and its forbidden zones, as boxes for the picture.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "view/opening.h"

namespace kadr {

/// A box in machine coordinates X, Y, Z, mm. nullopt: the box has no face on that side.
struct SpaceBox {
  std::array<std::optional<double>, 3> least, most;
};

struct ForbiddenZone {
  int number = 2;      // number of the zone in the control (nct 22)
  bool inside = true;  // true: the tool must stay outside the box; false: inside
  SpaceBox box;
};

struct MachineBounds {
  SpaceBox limits;  // box between the end positions of the axes
  std::vector<ForbiddenZone> zones;
};

/// Returns the limits in force at the start of the program. The program may change zone 2 later, with G22.
MachineBounds machine_bounds(const OpenedProgram& opened, const Control& control);

}  // namespace kadr
