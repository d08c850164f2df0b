#pragma once
// What the instruction of the 2С42 demands and its control does not stop for: warnings (6.3.6, 6.4.1, 6.7).

#include <cstdint>

#include "control/state.h"

namespace kadr {

class Machinery;

namespace s2c42 {

/// What of the program so far the demands ask for.
struct Musts {
  bool reference_seen = false;  // G25
  bool moved = false;
  bool at_rest = true;        // the last motion came to a stop at its end
  std::uint64_t shadows = 0;  // bit per number of a cycle whose own subprogram has been told of
};

/// Of a block, before it is carried out.
struct BlockBefore {
  bool in_body = false;  // of a cycle
  Plane plane = Plane::xy;
};
BlockBefore before(const Machinery& m);

/// Warns of what the block, now carried out, does against the instruction:
///   reference_again, reference_late  G25 once only, at the beginning of the program (6.4.1)
///   plane_without_stop               G9 at a change of planes, not needed with G0 (6.4.1); table 9 writes it beside G17
///   return_not_alone                 M17 in a block of its own, without motions (6.4.2)
///   length_beside_radius             one code of group 9 in a block (6.4.1): G43 beside G41
void check_musts(Machinery& m, const BlockBefore& before);

/// Warns once that the cycle of that number hides the program's own subprogram (6.7.1). `where`: of the call or of its first block.
void warn_of_shadow(Machinery& m, std::uint32_t number, Span where);

}  // namespace s2c42
}  // namespace kadr
