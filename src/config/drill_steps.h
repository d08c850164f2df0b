#pragma once
// What a drilling cycle does, operation by operation (spec/nct/18.1): DrillingRun of control/fanuc carries it out, kadr explain tells it.

#include <array>
#include <cstdint>

namespace kadr {

enum class DrillStep : std::uint8_t {
  end,
  approach,     // 3: rapid to R
  stop,         // of single-block operation
  cut,          // 5: feed to the bottom
  cut_fixed,    // 5: the same, overrides 100 %
  break_chips,  // 5: pecks, a little back
  clear_chips,  // 5: pecks, back to R
  tap_down,     // 5: with the spindle, in one go or in pecks
  pause,        // 6
  back,         // 7: feed to R, percent of the feed
  back_fixed,   // 7: feed to R, overrides 100 %
  tap_up,       // 7: with the spindle
  retract,      // 7, 9: rapid to R (G99) or at once to the initial point (G98)
  clear,        // 9: rapid to the initial point (G98)
  initial,      // 9: the same, whatever G98, G99
  shift_out,
  shift_back,
  cw,
  ccw,
  halt,
  orient,
  catch_spindle,
  manual,  // M0
};

/// Operations 2 … 10 between the single-block stops after 1 and 10.
struct DrillCycle {
  std::int32_t code;
  std::array<DrillStep, 14> steps;
};

constexpr std::int32_t back_boring = 1870;   // G87 of case B (18.1.13)
constexpr std::int32_t bored_by_hand = 871;  // a G87 that has no case B (spec/haas 8.6)
constexpr std::int32_t only_back = 877;      // G77: case B alone (spec/haas 8.6)

/// The cycle of a code, ten times its number; nullptr, if it is none.
const DrillCycle* drill_cycle(std::int32_t code);

}  // namespace kadr
