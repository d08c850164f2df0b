#pragma once
// Programmed axes that drive a machine axis other than their own (exchanged axes) or in reverse; parked axes (spec/nct/20 20.2 to 20.5).

#include <optional>
#include <string>
#include <vector>

#include "action/action.h"
#include "action/placement.h"
#include "config/setup/setup.h"

namespace kadr {
class BlockContext;
class Emitter;
}  // namespace kadr

namespace kadr::nct {

/// A request of the machine's logic to exchange, reverse or park an axis, received since the last block.
struct AxisRequest {
  std::size_t axis;
  AxisLink link;
  bool on;
  // machine coordinate in mm of the axis with which this axis is exchanged; set only if that axis is in another channel
  std::optional<double> machine{};
};

/// The axes that are exchanged, reversed or parked. Together with parameters N2104 and N2105, these axes determine fanuc::Memory::driven.
struct Drives {
  AxisMask exchanged = 0;  // axes for which the machine's logic has requested an exchange
  AxisMask mirrored = 0;
  AxisMask parked = 0;
  AxisMask far = 0;           // axes that drive an axis of another channel
  AxisMask far_reversed = 0;  // axes that drive an axis of another channel in the reversed direction
  Axes standing{};            // machine coordinates of the parked axes, mm or degrees
  std::vector<AxisRequest> requests;
};

/// Returns true if the axis is linear, is neither coupled nor exchanged, and belongs to no five-axis function.
bool may_be_exchanged(const BlockContext& m, std::size_t axis);

/// Stores a request of the machine's logic until the next block begins.
void request_axis(BlockContext& m, const std::string& name, AxisLink link, bool on);

/// Executes the stored requests. Nothing moves; a work coordinate becomes that of the machine axis that the programmed axis now drives.
///   warns  axis_not_changed
void execute_requests(Emitter& m);

/// Called after power-off: each axis drives its own machine axis again.
void end_drives(Emitter& m);

/// Sets the parked axes in a motion to the positions at which they are parked.
void keep_parked(BlockContext& m, Motion& motion);

}  // namespace kadr::nct
