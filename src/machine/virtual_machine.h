#pragma once
// VirtualMachine: follows the actions, checks axis limits and zones, and answers probe motions.

#include <functional>
#include <optional>

#include "base/result.h"
#include "config/machine_profile.h"
#include "config/setup.h"
#include "machine/probe.h"
#include "machine/zones.h"
#include "path/curve/machine_extents.h"
#include "path/smooth/compression.h"

namespace kadr {

class VirtualMachine {
 public:
  /// `start` is the position of the tool before the first action (Control::ending() at that time).
  VirtualMachine(const std::vector<std::string>& axes, AxisMask rotary, const MachineProfile& profile, const Setup& setup,
                 const ToolPosition& start);

  /// Sets the limits of an axis that neither the set-up nor the machine file limits, in machine coordinates.
  void limit(std::size_t axis, double least, double most);

  /// Makes it the machine of an NCT, whose parameters define zones and in-position windows (nct 4.1.1, 22).
  void obey_parameters(const Setup& setup);

  using OnTouch = std::function<void(const ProbeAnswer&)>;
  enum class Follows : std::uint8_t { more, nothing };

  /// The outcome of a batch.
  struct Outcome {
    std::size_t done = 0;        // this many actions of the batch are executed
    bool refused = false;        // nothing of the last block is executed
    std::optional<Alarm> alarm;  // of the refusal, or of axes that did not come into position
    Origin origin;               // of the action that caused it
  };

  /// Executes a batch up to the first alarm. Short motions are joined (Compression), and some may be held back for the next batch. A
  /// probe motion ends where it touches something.
  ///   on_touch  receives the answer to each executed probe motion
  ///   alarms    as take() and in_position()
  Outcome take(ActionBatch& batch, Follows follows, const OnTouch& on_touch);

  /// Executes one action; a probe motion ends where it touches something.
  ///   alarms    as take(); with CBM also for the path that the probe motion would take without a signal
  Status carry_out(Action& action, const OnTouch& on_touch);

  /// Executes an action.
  ///   alarms  limit_exceeded (axis, position, limit), also for the extremes of curved paths, or the alarms of Zones; then nothing
  ///           has moved
  ///   law     an axis that is already outside may move inwards
  Status take(const Action& action);

  /// Checks that the axes have come into position after the last motion, if the motion asks for that.
  ///   alarms  gantry_apart (axis, difference, limit), after any motion (20.6); position_error (axis): INFERRED: an axis that moved
  ///           and stays farther from the command than N0516
  ///   manual  NCT 4.1.1, 6.3
  Status in_position() const;

  /// Returns what a straight probe motion from the present position touches.
  ProbeAnswer probe(const Motion& motion) const;

  /// True if a motion may be refused, or may stop the run after it.
  bool has_limits() const;

  const ToolPosition& position() const { return position_; }
  /// Restores an earlier position: the actions since then count as not executed.
  void go_back(const ToolPosition& to) { position_ = to; }
  const AxisRoles& roles() const { return roles_; }

  // ---- axes that follow axes of other channels (nct 20.2, 20.3)

  /// Lets the axis follow an axis of another channel (or ends this): no motion of this channel moves it.
  void hang(std::size_t axis, bool on) { hung_ = on ? hung_ | AxisMask{1} << axis : hung_ & ~(AxisMask{1} << axis); }
  /// Moves a following axis, and the axes of this channel that follow it, to these work and machine coordinates.
  ///   alarms  as take(); then nothing has moved
  Status follow(const Axes& work, const Axes& machine, AxisMask moved);
  /// Exchanges an axis with one of another channel's machine: each keeps its name, its limits and its position.
  void exchange(std::size_t axis, VirtualMachine& with, std::size_t other);

  /// The state that lasts from batch to batch.
  struct Memory {
    ToolPosition position;
    AxisMask missing = 0;
    Compression::Memory compression{};
    std::optional<Zones::Memory> zones{};
  };
  Memory memory() const;
  void remember(const Memory& memory);

  /// Sets a signal of the machine's logic: CP_LIM2DIS and CP_LIM3DIS suspend the check of a zone (nct 22.2, 22.3); others have no
  /// effect here.
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
  AxisMask limited_ = 0;  // axes that have a limit
  std::optional<Zones> zones_;
  AxisMask hung_ = 0;
  AxisMask never_in_position_ = 0;  // axes whose position error is greater than permitted
  AxisMask missing_ = 0;            // axes not in position after the last motion
  std::optional<Alarm> apart_;      // the drives of a gantry axis differ by more than permitted …
  AxisMask gantry_ = 0;             // … of this axis and its master
  bool gantry_moved_ = false;       // by the last motion
  Probe probe_;
  Compression compression_;
  ToolPosition position_;
};

/// Shortens a probe motion to where the signal came. `turn` is the rotation of the frame in which it moves.
void end_at(Motion& motion, const ProbeAnswer& answer, const FrameTurn* turn = nullptr);

}  // namespace kadr
