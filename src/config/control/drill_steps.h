#pragma once
// The operations of each drilling cycle (spec/nct/18.1). DrillingRun of control/fanuc executes them, kadr explain prints them.

#include <array>
#include <cstdint>

namespace kadr {

enum class DrillStep : std::uint8_t {
  end,
  approach,     // operation 3 of the manual (as the number in each row below): rapid to R
  stop,         // stop in single-block mode
  cut,          // 5: feed to the bottom
  cut_fixed,    // 5: feed to the bottom, overrides 100 %
  break_chips,  // 5: pecks, retracting a little after each
  clear_chips,  // 5: pecks, retracting to R after each
  tap_down,     // 5: feed to the bottom, synchronised with the spindle, at once or in pecks
  pause,        // 6: dwell
  back,         // 7: feed to R at a percentage of the feed
  back_fixed,   // 7: feed to R, overrides 100 %
  tap_up,       // 7: feed back, synchronised with the spindle
  retract,      // 7, 9: rapid to R (G99), or directly to the initial point (G98)
  clear,        // 9: rapid to the initial point (G98)
  initial,      // 9: rapid to the initial point, whether G98 or G99
  shift_out,
  shift_back,
  cw,
  ccw,
  halt,
  orient,
  catch_spindle,
  manual,  // the operator works by hand, as after M0
};

/// A drilling cycle: its operations 2 … 10, between the single-block stops after operations 1 and 10.
struct DrillCycle {
  std::int32_t code;
  std::array<DrillStep, 14> steps;
};

constexpr std::int32_t back_boring = 1870;   // G87, case B (18.1.13)
constexpr std::int32_t bored_by_hand = 871;  // G87 of a control without case B (spec/haas 8.6)
constexpr std::int32_t only_back = 877;      // G77: always case B (spec/haas 8.6)

/// Returns the cycle of a code, given as ten times its number; nullptr if the code is no drilling cycle.
const DrillCycle* drill_cycle(std::int32_t code);

}  // namespace kadr
