#pragma once
// Axes that drive others than their own: exchanged, reversed; parked ones (spec/nct/20 20.2 to 20.5).

#include <optional>
#include <string>
#include <vector>

#include "action/action.h"
#include "action/placement.h"
#include "config/setup.h"

namespace kadr {
class BlockContext;
class Emitter;
}  // namespace kadr

namespace kadr::nct {

/// What the machine's logic has asked of an axis since the last block.
struct AskedOfAxis {
  std::size_t axis;
  AxisLink link;
  bool on;
  std::optional<double> machine{};  // exchanged with an axis of another channel: where that stands
};

/// What follows from the masks, N2104 and N2105: fanuc::Memory::driven.
struct Drives {
  AxisMask exchanged = 0;  // axes that have initiated it
  AxisMask mirrored = 0;
  AxisMask parked = 0;
  AxisMask far = 0;           // axes that drive one of another channel
  AxisMask far_reversed = 0;  // … the other way round
  Axes standing{};            // machine positions of the parked axes
  std::vector<AskedOfAxis> asked;
};

/// It is linear, and neither coupled, exchanged, nor one of a five-axis machine.
bool may_be_exchanged(const BlockContext& m, std::size_t axis);

/// Until the next block begins.
void ask_of_axis(BlockContext& m, const std::string& name, AxisLink link, bool on);

/// Nothing moves; work coordinates are those of the axes that are driven now.
///   warns  axis_not_changed
void carry_out_asked(Emitter& m);

/// Power has been off: each axis is its own again.
void end_drives(Emitter& m);

/// The parked axes of a motion stand.
void keep_parked(BlockContext& m, Motion& motion);

}  // namespace kadr::nct
