#pragma once
// Axes that follow others: synchronous axes, gantry axes (spec/nct/20 20.2, 20.6).

#include <optional>
#include <string>
#include <vector>

#include "action/action.h"
#include "base/result.h"
#include "config/setup_file.h"
#include "control/state/far_axis.h"

namespace kadr {
class BlockContext;
class Emitter;
}  // namespace kadr

namespace kadr::nct {

/// The axes that follow others now (fanuc::Memory::following has their mask, including those that follow axes of other channels). The
/// machine position of a follower is lead + sign · machine position of its master.
struct Couplings {
  std::vector<Follower> followers;  // each one after its master
  std::vector<FarAxis> far;         // axes that follow axes of other channels, or are exchanged with them
  Axes lead{};                      // by axis, mm or degrees
};

/// Returns the axis of the channel with this number, if it is not `axis` itself.
std::optional<std::size_t> axis_numbered(const BlockContext& m, double number, std::size_t axis);

/// True if an axis of another channel has this number.
bool is_far_axis(const BlockContext& m, double number);

/// Returns a sentence about the first coupling that the set-up's events request but that is impossible; empty if all are possible.
SetupFault coupling_fault(const BlockContext& m, const std::vector<SetupEvent>& events);

/// Moves gantry axes (N2102 #4 PSN=1) to the positions of their masters, which they follow from then on.
void couple_gantries(BlockContext& m);

/// Executes a request of the machine's logic: an axis starts or stops following the master that N2101 names. An axis of another channel
/// is ignored, but may be the master.
void couple_axis(Emitter& m, const std::string& name, bool on);

/// Starts or ends a link between an axis and an axis of another channel.
void link_far(BlockContext& m, const FarAxis& axis, bool on);

/// alarms  axis_follows: one of the named axes follows another axis
Status not_following(const BlockContext& m, AxisMask named);

/// Moves the followers of a motion whose masters are already at its end.
void follow(BlockContext& m, Motion& motion);

/// Recomputes `lead` after the tool's position has changed (a probe has touched, a block was undone, an axis has rolled over).
void follow_from_here(BlockContext& m);

}  // namespace kadr::nct
