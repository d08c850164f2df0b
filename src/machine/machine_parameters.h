#pragma once
// Parameters of the set-up that the machine itself obeys, for each axis of the channel: safety zones and the in-position window (nct 4.1.1,
// 22). Values that a program writes for zone 2 take effect at G23 (nct 22.2; ZoneChange). INFERRED: values that a program writes for the
// other parameters take effect at the next start of the machine.

#include <array>
#include <string>
#include <vector>

#include "base/vec.h"
#include "config/setup/setup.h"

namespace kadr {

struct MachineParameters {
  AxisMask zone2_axes = 0;         // N1000 #1 RE2: axes that zone 2 limits
  AxisMask zone3_axes = 0;         // N1000 #2 RE3: axes that zone 3 limits
  Axes zone2_most{};               // N1006: upper limits of zone 2, machine coordinates
  Axes zone2_least{};              // N1007: lower limits of zone 2, machine coordinates
  bool outside_forbidden = false;  // N1001 #0 EXT: true if the outside of zone 2 is forbidden; false if its inside is forbidden
  bool zone2_on = false;           // N1001 #1 STE: true if zone 2 is active
  bool checks_before = false;      // N1001 #2 CBM: true if motions are checked before they start
  Axes in_position{};              // N0516 Inpos: greatest deviation from the commanded position that counts as in position, mm or degrees
  AxisMask gantry = 0;             // N2102 #4 PSN: slave drives of gantry axes, which follow their master's drive
  std::array<std::size_t, max_axes> gantry_master{};  // N2101: index of the master axis of each gantry axis
};

/// Reads the parameters of the set-up. A value with an axis index takes precedence over a value without index, and a single bit of a
/// parameter over its whole value, as in ParameterStore.
MachineParameters machine_parameters(const Setup& setup, const std::vector<std::string>& axes);

}  // namespace kadr
