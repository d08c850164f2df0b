#pragma once
// VirtualMachine: moves the axes as the actions demand, checks axis limits and zones, and computes where probe motions end.

#include <functional>
#include <optional>

#include "base/result.h"
#include "config/machine/machine_profile.h"
#include "config/setup/setup.h"
#include "machine/probe.h"
#include "machine/zones.h"
#include "path/curve/machine_extents.h"
#include "path/smooth/compression.h"

namespace kadr {

class VirtualMachine {
 public:
  /// Creates the machine. `start` is the position of the tool before the first action, as Control::ending() returns it at that time.
  VirtualMachine(const std::vector<std::string>& axes, AxisMask rotary, const MachineProfile& profile, const Setup& setup,
                 const ToolPosition& start);

  /// Sets the limits of an axis, in machine coordinates. Has no effect on an axis whose limits the set-up or the machine file states.
  void limit(std::size_t axis, double least, double most);

  /// Makes this object a machine with an NCT control, whose parameters define zones and in-position windows (nct 4.1.1, 22).
  void obey_parameters(const Setup& setup);

  using OnTouch = std::function<void(const ProbeAnswer&)>;
  enum class Follows : std::uint8_t { more, nothing };

  /// What happened to the actions of a batch.
  struct Outcome {
    std::size_t done = 0;        // number of actions of the batch that have been executed
    bool refused = false;        // true if an action was refused; then no action of the same block counts as executed
    std::optional<Alarm> alarm;  // alarm of the refused action, or alarm that the axes did not reach their position
    Origin origin;               // block of the action that caused the alarm
  };

  /// Executes a batch up to the first alarm. Short motions are joined (Compression); some of them may be stored until the next batch. A
  /// probe motion ends at the point where the probe touches something.
  ///   on_touch  receives the answer to each executed probe motion
  ///   alarms    those of take(const Action&) and in_position()
  Outcome take(ActionBatch& batch, Follows follows, const OnTouch& on_touch);

  /// Executes one action. A probe motion ends at the point where the probe touches something.
  ///   alarms    those of take(const Action&); with N1001#2 CBM also for the path that the probe motion would travel without a signal
  Status execute(Action& action, const OnTouch& on_touch);

  /// Executes an action unchanged: a probe motion goes to its programmed end.
  ///   alarms  limit_exceeded (axis, position, limit), also if only the extreme of a curved path exceeds the limit, or the alarms of
  ///           Zones; after an alarm nothing has moved
  ///   law     an axis that is already beyond a limit may move back towards the permitted range
  Status take(const Action& action);

  /// Checks that the axes have reached their positions after the last motion, if that motion requests the check.
  ///   alarms  gantry_apart (axis, difference, limit), after any motion (nct 20.6); position_error (axis), if an axis that moved stays
  ///           farther from its commanded position than N0516 (INFERRED)
  ///   manual  NCT 4.1.1, 6.3
  Status in_position() const;

  /// Returns the point at which a straight probe motion from the present position touches something.
  ProbeAnswer probe(const Motion& motion) const;

  /// Returns true if this machine may refuse a motion, or may stop the program after a motion.
  bool has_limits() const;

  const ToolPosition& position() const { return position_; }
  /// Restores an earlier position. The actions executed since that position count as not executed.
  void go_back(const ToolPosition& to) { position_ = to; }
  const AxisRoles& roles() const { return roles_; }

  // ---- axes that follow axes of other channels (nct 20.2, 20.3)

  /// Makes the axis follow an axis of another channel, or ends this (`on` false). While the axis follows, motions of this channel do not
  /// move it.
  void hang(std::size_t axis, bool on) { hung_ = on ? hung_ | AxisMask{1} << axis : hung_ & ~(AxisMask{1} << axis); }
  /// Moves the axes `moved`, which follow axes of another channel, to the given work and machine coordinates. Axes of this channel that
  /// follow the axes `moved` move too.
  ///   alarms  those of take(); after an alarm nothing has moved
  Status follow(const Axes& work, const Axes& machine, AxisMask moved);
  /// Exchanges an axis with an axis of another channel's machine: each axis keeps its name, its limits and its position.
  void exchange(std::size_t axis, VirtualMachine& with, std::size_t other);

  /// The state of the machine between two batches of actions.
  struct Memory {
    ToolPosition position;
    AxisMask missing = 0;
    Compression::Memory compression{};
    std::optional<Zones::Memory> zones{};
  };
  Memory memory() const;
  void resume_from(const Memory& memory);

  /// Sets a signal of the machine's logic. CP_LIM2DIS and CP_LIM3DIS suspend the check of zone 2 or 3 (nct 22.2, 22.3); other signals
  /// have no effect here.
  void set_signal(std::string_view name, bool on);

 private:
  Status check(const Motion& motion) const;
  Status check_curve(const Motion& motion) const;
  void watch_gantry(const Setup& setup, std::size_t axis, std::size_t master);
  void leave_hung(Motion& motion) const;
  tl::unexpected<Alarm> beyond(std::size_t axis, double machine) const;

  std::vector<std::string> names_;
  AxisRoles roles_;
  Axes least_{};
  Axes most_{};
  AxisMask limited_ = 0;  // axes that have limits
  std::optional<Zones> zones_;
  AxisMask hung_ = 0;
  AxisMask never_in_position_ = 0;  // axes whose position error in the set-up exceeds the permitted error
  AxisMask missing_ = 0;            // axes that did not reach their position in the last motion
  std::optional<Alarm> apart_;      // alarm that the two drives of a gantry axis are farther apart than permitted
  AxisMask gantry_ = 0;             // the gantry axis whose drives are too far apart (see apart_), and its master axis
  bool gantry_moved_ = false;       // true if the last motion moved a gantry axis
  Probe probe_;
  Compression compression_;
  ToolPosition position_;
};

/// Shortens a probe motion so that it ends at the point where the probe triggered. `turn` is the rotation of the frame in which the motion
/// is programmed.
void end_at(Motion& motion, const ProbeAnswer& answer, const FrameTurn* turn = nullptr);

}  // namespace kadr
