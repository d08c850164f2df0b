#pragma once
// GearWatch: checks that the rotary table of an electronic gearbox can turn as fast as the spindle demands. The spindle demands 360·S·|L|/T
// °/min of the table, which must not exceed the table's rapid rate (NCT 20.1 item 4).

#include <optional>
#include <string>
#include <vector>

#include "action/by_kind.h"

namespace kadr {

struct GearTooFast {
  std::size_t axis = 0;
  double speed = 0;  // speed that the spindle demands of the rotary axis, °/min
};

class GearWatch {
 public:
  /// Returns true if the action may change the speed that the spindle demands of the table.
  bool concerns(const Action& action) const {
    return by_kind(action, same<Couple>(true), same<Uncouple, Spindle, Speed>(on_),
                   same<Motion, Dwell, CoolantSwitch, ToolSelect, ToolChange, MachineFunction, AuxiliaryFunction, Stop, Message,
                        FrameChange, SurfaceSpeed, Sync, ZoneChange, CompensationBreak, CompensationCorner, CompensationCheck>(false));
  }
  /// Returns the rotary table's axis and the demanded speed if the action makes the spindle demand more than the axis' rapid rate; else
  /// nullopt.
  std::optional<GearTooFast> look(const Action& action, const std::vector<std::string>& axes, const Axes& most);

 private:
  bool on_ = false, turns_ = false;
  double ratio_ = 0, rpm_ = 0;  // ratio_: revolutions of the slave per revolution of the master, rpm_: speed of the master in rev/min
  int master_ = 0;
  std::size_t slave_ = max_axes;
};

}  // namespace kadr
