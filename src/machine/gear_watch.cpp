// Checks the table speed that the electronic gearbox demands. Used by session/channel_run; tested by tests/faulty/nct/gear-*.

#include "machine/gear_watch.h"

#include <algorithm>
#include <cmath>

#include "action/by_kind.h"

namespace kadr {

std::optional<GearTooFast> GearWatch::look(const Action& action, const std::vector<std::string>& axes, const Axes& most) {
  by_kind(
      action,
      [&](const Couple& couple) {
        on_ = true;
        ratio_ = couple.ratio;
        master_ = couple.master_number;
        turns_ = couple.rpm != 0;
        rpm_ = couple.rpm / couple.ratio;
        slave_ = static_cast<std::size_t>(std::find(axes.begin(), axes.end(), couple.slave) - axes.begin());
      },
      [&](const Uncouple&) { on_ = false; },
      [&](const Spindle& spindle) {
        if (spindle.number != master_) return;
        turns_ = spindle.dir == SpindleDir::cw || spindle.dir == SpindleDir::ccw;
        rpm_ = spindle.rpm;
      },
      [&](const Speed& speed) {
        if (speed.number == master_ && !speed.surface) rpm_ = speed.value;
      },
      ignores<Motion, Dwell, CoolantSwitch, ToolSelect, ToolChange, MachineFunction, AuxiliaryFunction, Stop, Message, FrameChange,
              SurfaceSpeed, Sync, ZoneChange, CompensationBreak, CompensationCorner, CompensationCheck>);
  if (!on_ || !turns_ || slave_ >= axes.size()) return std::nullopt;
  constexpr double turn = 360, rounding = 1e-9;
  const double needed = turn * std::fabs(rpm_ * ratio_);
  if (!(most[slave_] > 0) || needed <= most[slave_] * (1 + rounding)) return std::nullopt;
  return GearTooFast{slave_, needed};
}

}  // namespace kadr
