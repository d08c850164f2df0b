#pragma once
// EndReference: the coordinate system of a motion's end: the work offset, the machine, or a reference point.

#include <cstdint>

namespace kadr {

/// What determines the end of a motion. When a work offset changes, only ends of the kind `by_work` move with the offset.
enum class EndReference : std::uint8_t {
  by_work,      // the end is given in work coordinates
  by_machine,   // the end is given in machine coordinates: G53
  reference_1,  // the end is the reference point of G28
  reference_2,  // reference_2 to reference_4: the end is the reference point of G30 P2 to G30 P4
  reference_3,
  reference_4,
};
inline int reference_of(EndReference end) {  // returns the number of the reference point, 1 to 4; 0 if the end is no reference point
  return end < EndReference::reference_1 ? 0 : int(end) - int(EndReference::reference_1) + 1;
}

}  // namespace kadr
