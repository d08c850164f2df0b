#pragma once
// Parameters of the set-up that the machine itself obeys, for each axis of the channel: safety zones and the in-position window (nct 4.1.1,
// 22). Values that a program writes for zone 2 take effect at G23 (nct 22.2; ZoneChange). INFERRED: values that a program writes for the
// other parameters take effect at the next start.

#include <array>
#include <string>
#include <vector>

#include "base/vec.h"
#include "config/setup/setup.h"

namespace kadr {

struct MachineParameters {
  AxisMask zone2_axes = 0;                            // N1000 #1 RE2
  AxisMask zone3_axes = 0;                            // N1000 #2 RE3
  Axes zone2_most{};                                  // N1006, machine coordinates
  Axes zone2_least{};                                 // N1007
  bool outside_forbidden = false;                     // N1001 #0 EXT
  bool zone2_on = false;                              // N1001 #1 STE
  bool checks_before = false;                         // N1001 #2 CBM
  Axes in_position{};                                 // N0516 Inpos, mm or degrees
  AxisMask gantry = 0;                                // N2102 #4 PSN: slave drives that follow their master's drive
  std::array<std::size_t, max_axes> gantry_master{};  // N2101: index of the master of each gantry axis
};

/// Reads the parameters. A value with an index takes precedence over a value without index, and a bit of a parameter over its whole value
/// (as in ParameterStore).
///   axes  names of the channel's axes
MachineParameters machine_parameters(const Setup& setup, const std::vector<std::string>& axes);

}  // namespace kadr
