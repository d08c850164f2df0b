#pragma once
// The operations of each drilling cycle (spec/nct/18.1). DrillingRun of control/fanuc executes them, kadr explain prints them.

#include <array>
#include <cstdint>

namespace kadr {

enum class DrillStep : std::uint8_t {
  end,
  approach,     // operation 3: rapid to R. The numbers here and below are those of the operations in nct 18.1
  stop,         // stop in single-block mode
  cut,          // operation 5: feed to the bottom
  cut_fixed,    // operation 5: feed to the bottom, overrides 100 %
  break_chips,  // operation 5: pecks, retracting a little after each
  clear_chips,  // operation 5: pecks, retracting to R after each
  tap_down,     // operation 5: feed to the bottom, synchronised with the spindle, at once or in pecks
  pause,        // operation 6: dwell
  back,         // operation 7: feed to R at a percentage of the feed
  back_fixed,   // operation 7: feed to R, overrides 100 %
  tap_up,       // operation 7: feed to R, synchronised with the spindle
  retract,      // operations 7 and 9: rapid to R (G99), or directly to the initial point (G98)
  clear,        // operation 9: rapid to the initial point (G98)
  initial,      // operation 9: rapid to the initial point, whether G98 or G99
  shift_out,
  shift_back,
  cw,
  ccw,
  halt,
  orient,
  catch_spindle,
  manual,  // the operator works by hand, as after M0
};

/// A drilling cycle: its operations 2 … 10 (nct 18.1), which are between the single-block stops after operations 1 and 10.
struct DrillCycle {
  std::int32_t code;
  std::array<DrillStep, 14> steps;
};

constexpr std::int32_t back_boring = 1870;   // G87, case B (nct 18.1.13)
constexpr std::int32_t bored_by_hand = 871;  // G87 of a control without case B (spec/haas 8.6)
constexpr std::int32_t only_back = 877;      // G77: always case B (spec/haas 8.6)

/// Returns the cycle of a code, given as ten times its number; nullptr if the code is no drilling cycle.
const DrillCycle* drill_cycle(std::int32_t code);

}  // namespace kadr
