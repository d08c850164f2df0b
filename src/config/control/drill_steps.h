#pragma once
// The operations of each drilling cycle (spec/nct/18.1). DrillingRun (control/fanuc) executes these operations, and `kadr explain` prints
// them.

#include <array>
#include <cstdint>

namespace kadr {

enum class DrillStep : std::uint8_t {
  end,
  approach,     // operation 3 of nct 18.1 (so are the numbers below): rapid to R
  stop,         // the cycle stops here in single-block mode
  cut,          // operation 5: feed to the bottom
  cut_fixed,    // operation 5: feed to the bottom, with overrides at 100 %
  break_chips,  // operation 5: pecks to the bottom; the tool retracts a little after each peck
  clear_chips,  // operation 5: pecks to the bottom; the tool retracts to R after each peck
  tap_down,     // operation 5: feed to the bottom, synchronised with the spindle, without pecks or in pecks
  pause,        // operation 6: dwell at the bottom
  back,         // operation 7: feed to R at a percentage of the feed
  back_fixed,   // operation 7: feed to R, with overrides at 100 %
  tap_up,       // operation 7: feed to R, synchronised with the spindle
  retract,      // operations 7 and 9: rapid to R (G99), or directly to the initial point (G98)
  clear,        // operation 9: rapid to the initial point (G98)
  initial,      // operation 9: rapid to the initial point, under G98 and also under G99
  shift_out,
  shift_back,
  cw,
  ccw,
  halt,
  orient,
  catch_spindle,
  manual,  // the operator moves the tool by hand, as after M0
};

/// A drilling cycle: its operations 2 to 10 (nct 18.1). In single-block mode, the cycle stops after operations 1 and 10.
struct DrillCycle {
  std::int32_t code;
  std::array<DrillStep, 14> steps;
};

constexpr std::int32_t back_boring = 1870;   // code of G87, case B (nct 18.1.13)
constexpr std::int32_t bored_by_hand = 871;  // code of G87 on a control without case B (spec/haas 8.6)
constexpr std::int32_t only_back = 877;      // code of G77, which always executes case B (spec/haas 8.6)

/// Returns the drilling cycle of a code. `code`: ten times the number of the code. Returns nullptr if the code is no drilling cycle.
const DrillCycle* drill_cycle(std::int32_t code);

}  // namespace kadr
