#pragma once
// VirtualMachine: follows the Actions, guards the axis limits and zones, and says what a probe meets.

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
  /// `start`: where the tool stands before the first action (Control::ending() then).
  VirtualMachine(const std::vector<std::string>& axes, AxisMask rotary, const MachineProfile& profile, const Setup& setup,
                 const ToolPosition& start);

  /// An axis that neither set-up nor machine file limits gets these limits, machine coordinates.
  void limit(std::size_t axis, double least, double most);

  /// The machine of an NCT: its parameters give zones and in-position windows (nct 4.1.1, 22).
  void obey_parameters(const Setup& setup);

  using OnTouch = std::function<void(const ProbeAnswer&)>;
  enum class Follows : std::uint8_t { more, nothing };

  /// What became of a batch.
  struct Outcome {
    std::size_t done = 0;        // so many of its first actions are done
    bool refused = false;        // nothing of the last block is done
    std::optional<Alarm> alarm;  // of a refusal, or of axes that did not come into position
    Origin origin;               // of the action that caused it
  };

  /// Carries out a batch, as far as nothing stops it. Short motions of it are joined (Compression), some may be held back for the next
  /// one; a probe motion ends where it meets something.
  ///   on_touch  gets the answer to a probe motion that was carried out
  ///   alarms    as take() and in_position()
  Outcome take(ActionBatch& batch, Follows follows, const OnTouch& on_touch);

  /// Carries out one action; a probe motion ends where it meets something.
  ///   alarms    as take(); with CBM also of the way that a probe motion would have gone without a signal
  Status carry_out(Action& action, const OnTouch& on_touch);

  /// Carries out an action.
  ///   alarms  limit_exceeded (axis, position, limit), the extremes of curved paths included, or those of Zones; then nothing has
  ///           moved
  ///   law     an axis that already stands outside may go inwards
  Status take(const Action& action);

  /// Whether the axes have come into position after the motion taken last, where it asks for that.
  ///   alarms  gantry_apart (axis, difference, limit), whatever it asks for (20.6); position_error (axis): INFERRED: an axis that moved and
  ///   stays further from the command than N0516 manual  NCT 4.1.1, 6.3
  Status in_position() const;

  /// What a straight probe motion from here meets on its way.
  ProbeAnswer probe(const Motion& motion) const;

  /// Motions may be refused, or stop the run after them.
  bool has_limits() const;

  const ToolPosition& position() const { return position_; }
  /// The actions since then are not carried out after all.
  void go_back(const ToolPosition& to) { position_ = to; }
  const AxisRoles& roles() const { return roles_; }

  // ---- axes that hang on those of other channels (nct 20.2, 20.3)

  /// The axis goes with one of another channel: no motion of this one moves it.
  void hang(std::size_t axis, bool on) { hung_ = on ? hung_ | AxisMask{1} << axis : hung_ & ~(AxisMask{1} << axis); }
  /// It, and what follows it here, has come there: work and machine coordinates.
  ///   alarms  as take(); then nothing has moved
  Status follow(const Axes& work, const Axes& machine, AxisMask moved);
  /// The axis and one of another channel's machine have been exchanged: each keeps its name, its limits and where it stands.
  void exchange(std::size_t axis, VirtualMachine& with, std::size_t other);

  /// What it remembers from batch to batch.
  struct Memory {
    ToolPosition position;
    AxisMask missing = 0;
    Compression::Memory compression{};
    std::optional<Zones::Memory> zones{};
  };
  Memory memory() const;
  void remember(const Memory& memory);

  /// A signal of the machine's logic: CP_LIM2DIS, CP_LIM3DIS hold the check of a zone off (nct 22.2, 22.3); others say nothing here.
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
  AxisMask never_in_position_ = 0;  // axes that stay further from the command than they may
  AxisMask missing_ = 0;            // of the last motion
  std::optional<Alarm> apart_;      // the drives of a gantry axis are further from each other than they may be …
  AxisMask gantry_ = 0;             // … this one, its master
  bool gantry_moved_ = false;       // by the last motion
  Probe probe_;
  Compression compression_;
  ToolPosition position_;
};

/// The probe motion as it really went: ends where the signal came. `turn`: of the frame it goes in.
void end_at(Motion& motion, const ProbeAnswer& answer, const FrameTurn* turn = nullptr);

}  // namespace kadr
