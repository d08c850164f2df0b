#pragma once
// Axes that follow a master axis: synchronous axes and gantry axes (spec/nct/20 20.2, 20.6).

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

/// The axes that follow a master at present. The machine position of a follower is offset + sign · machine position of its master, where
/// `offset` and `sign` are constants of the follower. (fanuc::Memory::following has the mask of all followers, including those whose master
/// is in another channel.)
struct Couplings {
  std::vector<Follower> followers;    // the coupled axes of this channel, sorted so that each follower comes after its own master
  std::vector<CrossChannelAxis> far;  // axes of this channel that follow, or are exchanged with, axes of other channels
  Axes offset{};                      // for each follower, the constant `offset` of the equation above, mm or degrees
};

/// Returns the index of the axis of this channel whose control-wide number is `number`. Returns nullopt if this channel has no other axis
/// than `axis` with this number.
std::optional<std::size_t> axis_numbered(const BlockContext& m, double number, std::size_t axis);

/// Returns true if an axis of another channel has this control-wide number.
bool is_cross_channel_axis(const BlockContext& m, double number);

/// Returns the fault of the first impossible coupling among those that events of the set-up request; empty if all are possible.
SetupFault coupling_fault(const BlockContext& m, const std::vector<SetupEvent>& events);

/// Moves the gantry axes (N2102 #4 PSN=1) to the positions of their masters. From then on the gantry axes follow their masters.
void couple_gantries(BlockContext& m);

/// Makes an axis follow the master that N2101 names, or ends the coupling, as the machine's logic requests. A request for an axis of
/// another channel is ignored; the master may be in another channel.
void couple_axis(Emitter& m, const std::string& name, bool on);

/// Starts or ends the coupling of an axis with an axis of another channel.
void link_cross_channel(BlockContext& m, const CrossChannelAxis& axis, bool on);

/// Checks that none of the named axes follows a master.
///   alarms  axis_follows
Status not_following(const BlockContext& m, AxisMask named);

/// Adds the end positions of the followers to a motion that already has the end positions of their masters.
void follow(BlockContext& m, Motion& motion);

/// Recomputes `offset`, the constant of the coupling equation, of all followers after a position has changed without a motion: a probe has
/// made contact, a block was undone, an axis has rolled over.
void follow_from_here(BlockContext& m);

}  // namespace kadr::nct
