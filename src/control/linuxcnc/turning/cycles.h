#pragma once
// G70 to G72: the profile is in a subprogram, whose words are read without moving; then the cycle runs (spec/linuxcnc 7.2; convert_g7x of
// the source).

#include <cstddef>
#include <cstdint>

#include "base/result.h"
#include "control/linuxcnc/turning/passes.h"

namespace kadr {
class BlockContext;
class Emitter;
}  // namespace kadr

namespace kadr::linuxcnc {

/// A cycle whose profile is being read.
struct TurningCycle {
  std::int32_t code = 0;  // tenths: 711
  std::size_t depth = 0;  // number of open calls at the cycle's block
  bool absolute = true, centers_absolute = false;
  TurningWords words;
  Profile profile;
  Point at;  // end of the profile so far
  std::int32_t motion = 0;
  Span where;
};

/// Adds a block of the subprogram to the profile.
Status take_profile_block(BlockContext& m);
/// Computes the motions after the profile is complete, and starts them.
Status run_turning(Emitter& m);

}  // namespace kadr::linuxcnc
