#pragma once
// Turning cycles G70 to G72. The profile is in a subprogram, whose blocks are read without moving the tool; then the cycle is executed
// (spec/linuxcnc 7.2; convert_g7x of LinuxCNC's source).

#include <cstddef>
#include <cstdint>

#include "base/result.h"
#include "control/linuxcnc/turning/turning_passes.h"

namespace kadr {
class BlockContext;
class Emitter;
}  // namespace kadr

namespace kadr::linuxcnc {

/// The turning cycle whose profile is being read from its subprogram.
struct TurningCycle {
  std::int32_t code = 0;  // G code in tenths: 711 is G71.1
  std::size_t depth = 0;  // number of calls that were open at the block with the turning cycle
  bool absolute = true, centers_absolute = false;
  TurningWords words;
  Profile profile;
  Point at;  // end point of the last line or arc of the profile that was read
  std::int32_t motion = 0;
  Span where;
};

/// Adds the current block of the subprogram to the profile.
Status take_profile_block(BlockContext& m);
/// Computes the motions of the cycle when the profile is complete, and starts their execution.
Status run_turning(Emitter& m);

}  // namespace kadr::linuxcnc
