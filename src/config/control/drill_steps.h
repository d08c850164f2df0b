#pragma once
// The operations of each drilling cycle (spec/nct/18.1). DrillingRun (control/fanuc) executes these operations, and `kadr explain` prints
// them.

#include <array>
#include <cstdint>

namespace kadr {

enum class DrillStep : std::uint8_t {
  end,
  approach,     // operation 3 of a drilling cycle, as nct 18.1 numbers them: rapid to the R level
  stop,         // point at which the drilling cycle stops in single-block mode
  cut,          // operation 5 of a drilling cycle (nct 18.1): feed to the bottom of the hole
  cut_fixed,    // operation 5 of a drilling cycle: feed to the bottom of the hole, with overrides at 100 %
  break_chips,  // operation 5 of a drilling cycle: pecks to the bottom; the tool retracts a little after each peck
  clear_chips,  // operation 5 of a drilling cycle: pecks to the bottom; the tool retracts to the R level after each peck
  tap_down,     // operation 5 of a tapping cycle: feed to the bottom, synchronised with the spindle, without pecks or in pecks
  pause,        // operation 6 of a drilling cycle: dwell at the bottom of the hole
  back,         // operation 7 of a drilling cycle: feed to the R level at a percentage of the feed
  back_fixed,   // operation 7 of a drilling cycle: feed to the R level, with overrides at 100 %
  tap_up,       // operation 7 of a tapping cycle: feed to the R level, synchronised with the spindle
  retract,      // operations 7 and 9 of a drilling cycle: rapid to the R level (G99), or directly to the initial point (G98)
  clear,        // operation 9 of a drilling cycle: rapid to the initial point, only under G98
  initial,      // operation 9 of a drilling cycle: rapid to the initial point, under G98 and also under G99
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

constexpr std::int32_t back_boring = 1870;  // number that stands for case B of the cycle G87, back boring (nct 18.1.13)
// Number that stands for the cycle G87 on a control without case B: the operator moves the tool by hand (spec/haas 8.6)
constexpr std::int32_t bored_by_hand = 871;
// Number that stands for the cycle G77, which always bores backwards, like case B of G87 (spec/haas 8.6)
constexpr std::int32_t only_back = 877;

/// Returns the drilling cycle of a code. `code`: ten times the number of the code. Returns nullptr if the code is no drilling cycle.
const DrillCycle* drill_cycle(std::int32_t code);

}  // namespace kadr
