#pragma once
// Axes that follow a master axis: synchronous axes, gantry axes (spec/nct/20 20.2, 20.6).

#include <optional>
#include <string>
#include <vector>

#include "action/action.h"
#include "base/result.h"
#include "config/setup/setup_file.h"
#include "control/state/cross_channel_axis.h"

namespace kadr {
class BlockContext;
class Emitter;
}  // namespace kadr

namespace kadr::nct {

/// The axes that follow a master now (fanuc::Memory::following has their mask, including those whose master is in another channel). The
/// machine position of a follower is lead + sign · machine position of its master.
struct Couplings {
  std::vector<Follower> followers;    // each follower comes after its master
  std::vector<CrossChannelAxis> far;  // axes that follow axes of other channels, or are exchanged with them
  Axes lead{};                        // the constant `lead` of each follower, by axis, mm or degrees
};

/// Returns the index of the channel's axis with this control-wide number; nullopt if there is none or it is `axis` itself.
std::optional<std::size_t> axis_numbered(const BlockContext& m, double number, std::size_t axis);

/// True if an axis of another channel has this number.
bool is_cross_channel_axis(const BlockContext& m, double number);

/// Returns a sentence about the first coupling that the set-up's events request but that is impossible; empty if all are possible.
SetupFault coupling_fault(const BlockContext& m, const std::vector<SetupEvent>& events);

/// Moves gantry axes (N2102 #4 PSN=1) to the positions of their masters, which they follow from then on.
void couple_gantries(BlockContext& m);

/// Executes a request of the machine's logic: an axis starts or stops following the master that N2101 names. A request for an axis of
/// another channel is ignored, but such an axis may be the master.
void couple_axis(Emitter& m, const std::string& name, bool on);

/// Starts or ends a link between an axis and an axis of another channel.
void link_cross_channel(BlockContext& m, const CrossChannelAxis& axis, bool on);

/// Checks that no named axis follows a master. alarms  axis_follows
Status not_following(const BlockContext& m, AxisMask named);

/// Moves the followers along with a motion: the positions of their masters are already those at its end.
void follow(BlockContext& m, Motion& motion);

/// Recomputes `lead` of the followers after the tool's position has changed (a probe has touched, a block was undone, an axis has rolled
/// over).
void follow_from_here(BlockContext& m);

}  // namespace kadr::nct
