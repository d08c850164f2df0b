#pragma once
// EndGiven: whether a motion ends where the work zero says, or at a place of the machine.

#include <cstdint>

namespace kadr {

/// What gives the end of a motion: where the work zero is moved, only ends `by_work` move with it.
enum class EndGiven : std::uint8_t {
  by_work,      // work coordinates
  by_machine,   // machine coordinates: G53
  reference_1,  // a reference point: G28
  reference_2,  // G30, P2 to P4
  reference_3,
  reference_4,
};
inline int reference_of(EndGiven end) {  // 1 to 4; 0: none
  return end < EndGiven::reference_1 ? 0 : int(end) - int(EndGiven::reference_1) + 1;
}

}  // namespace kadr
