#pragma once
// The space that the machine's axes have, and what of it is forbidden, as boxes for the picture.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "view/opening.h"

namespace kadr {

/// Machine coordinates of X, Y, Z, mm. Nothing: without a limit there.
struct SpaceBox {
  std::array<std::optional<double>, 3> least, most;
};

struct ForbiddenZone {
  int number = 2;      // of the control (nct 22)
  bool inside = true;  // forbidden inside; else outside
  SpaceBox box;
};

struct MachineBounds {
  SpaceBox limits;  // end positions
  std::vector<ForbiddenZone> zones;
};

/// What holds at the start of the program: G22 may change zone 2.
MachineBounds machine_bounds(const OpenedProgram& opened, const Control& control);

}  // namespace kadr
