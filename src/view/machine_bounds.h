#pragma once
// machine_bounds: the space of the machine's axes, and its forbidden zones, as boxes for the picture.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "view/opening.h"

namespace kadr {

/// Machine coordinates of X, Y, Z, mm; nullopt: no limit on that side.
struct SpaceBox {
  std::array<std::optional<double>, 3> least, most;
};

struct ForbiddenZone {
  int number = 2;      // number of the zone in the control (nct 22)
  bool inside = true;  // forbidden inside; else outside
  SpaceBox box;
};

struct MachineBounds {
  SpaceBox limits;  // end positions
  std::vector<ForbiddenZone> zones;
};

/// The limits in force at the start of the program: G22 may change zone 2.
MachineBounds machine_bounds(const OpenedProgram& opened, const Control& control);

}  // namespace kadr
