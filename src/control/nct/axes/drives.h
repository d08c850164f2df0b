#pragma once
// Axes that drive another axis than their own: exchanged and reversed axes; parked axes (spec/nct/20 20.2 to 20.5).

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

/// A request of the machine's logic for an axis since the last block.
struct AskedOfAxis {
  std::size_t axis;
  AxisLink link;
  bool on;
  std::optional<double> machine{};  // if exchanged with an axis of another channel: the machine position of that axis
};

/// The state from which, with N2104 and N2105, fanuc::Memory::driven follows.
struct Drives {
  AxisMask exchanged = 0;  // axes that have initiated an exchange
  AxisMask mirrored = 0;
  AxisMask parked = 0;
  AxisMask far = 0;           // axes that drive an axis of another channel
  AxisMask far_reversed = 0;  // … in the reversed direction
  Axes standing{};            // machine positions of the parked axes
  std::vector<AskedOfAxis> asked;
};

/// True if the axis is linear, is neither coupled nor exchanged, and is no axis of a five-axis machine.
bool may_be_exchanged(const BlockContext& m, std::size_t axis);

/// Stores the request until the next block begins.
void ask_of_axis(BlockContext& m, const std::string& name, AxisLink link, bool on);

/// Executes the stored requests. Nothing moves; the work coordinates change to those of the axes that are driven now.
///   warns  axis_not_changed
void carry_out_asked(Emitter& m);

/// After power-off: every axis drives itself again.
void end_drives(Emitter& m);

/// Keeps the parked axes of a motion at their positions.
void keep_parked(BlockContext& m, Motion& motion);

}  // namespace kadr::nct
