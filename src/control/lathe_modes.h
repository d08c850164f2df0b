#pragma once
// LatheModes: what the panel of a lathe shows besides the modes of InForce: diameter programming, the feed per revolution, the law of the
// spindle speed, the row of the tool's offsets.

#include <cstdint>
#include <optional>

#include "action/surface_speed.h"
#include "base/vec.h"
#include "config/setup/setup.h"

namespace kadr {

struct LatheModes {
  AxisMask diameters = 0;               // axes in diameter programming, whose words state diameters
  std::optional<double> feed_per_turn;  // feed in force, mm per revolution of the spindle; nullopt: the feed is not per revolution
  SurfaceSpeed surface;                 // constant surface speed; `on` is false while the speed is programmed in rev/min
  std::uint32_t offset_row = 0;         // row of the offset table that gives the tool's length in force; 0: none
  ToolOffset offset;                    // this row as the program and the set-up have left it
};

}  // namespace kadr
