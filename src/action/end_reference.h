#pragma once
// EndReference: what the end of a motion refers to: the work offset or a fixed position of the machine.

#include <cstdint>

namespace kadr {

/// What specifies the end of a motion. If a work offset changes, only ends of the type `by_work` move with the offset.
enum class EndReference : std::uint8_t {
  by_work,      // work coordinates
  by_machine,   // machine coordinates: G53
  reference_1,  // the reference point of G28
  reference_2,  // reference_2 to reference_4: the reference point of G30 P2 to G30 P4
  reference_3,
  reference_4,
};
inline int reference_of(EndReference end) {  // returns the number of the reference point, 1 to 4; 0 if the end is no reference point
  return end < EndReference::reference_1 ? 0 : int(end) - int(EndReference::reference_1) + 1;
}

}  // namespace kadr
