#pragma once
// VirtualMachine: follows the Actions, guards the axis limits, and says what a probe meets.

#include "base/result.h"
#include "config/machine_profile.h"
#include "config/setup.h"
#include "machine/probe.h"
#include "path/machine_extents.h"

namespace kadr {

class VirtualMachine {
 public:
  /// `start`: where the tool stands before the first action (Control::ending() then).
  VirtualMachine(const std::vector<std::string>& axes, AxisMask rotary, const MachineProfile& profile, const Setup& setup,
                 const ToolPosition& start);

  /// Carries out an action.
  ///   alarms  limit_exceeded (axis, position, limit), the extremes of curved paths included; then nothing has moved
  ///   law     an axis that already stands outside may go inwards
  Status take(const Action& action);

  /// What a straight probe motion from here meets on its way.
  ProbeAnswer probe(const Motion& motion) const;

  /// Some axis has a limit: motions may be refused.
  bool has_limits() const;

  const ToolPosition& position() const { return position_; }
  /// The actions since then are not carried out after all.
  void go_back(const ToolPosition& to) { position_ = to; }
  const AxisRoles& roles() const { return roles_; }

 private:
  Status check(const Motion& motion) const;
  Status check_curve(const Motion& motion) const;
  tl::unexpected<Alarm> beyond(std::size_t axis, double machine) const;

  std::vector<std::string> names_;
  AxisRoles roles_;
  Axes least_{};
  Axes most_{};
  Probe probe_;
  ToolPosition position_;
};

/// The probe motion as it really went: ends where the signal came. `rotation`: of the frame it goes in.
void end_at(Motion& motion, const ProbeAnswer& answer, const FrameRotation* rotation = nullptr);

}  // namespace kadr
