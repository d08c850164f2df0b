#pragma once
// machine_bounds: the travel limits of the machine's axes and the machine's forbidden zones, as boxes for the picture.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "view/opening.h"

namespace kadr {

/// A box in machine coordinates X, Y, Z, in mm. A limit is nullopt if the box has no face on this side.
struct SpaceBox {
  std::array<std::optional<double>, 3> least, most;
};

struct ForbiddenZone {
  int number = 2;      // number of the zone in the control, 2 or 3 (nct 22)
  bool inside = true;  // true if the tool must stay outside the box; false if it must stay inside
  SpaceBox box;
};

struct MachineBounds {
  SpaceBox limits;  // box between the travel limits of the axes
  std::vector<ForbiddenZone> zones;
};

/// Returns the limits and zones in force at the start of the program. The program may change zone 2 later, with G22.
MachineBounds machine_bounds(const OpenedProgram& opened, const Control& control);

}  // namespace kadr
