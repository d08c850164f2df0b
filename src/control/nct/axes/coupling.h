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

/// The axes that follow now (fanuc::Memory::following: which, far ones too); machine = lead + sign · machine of the master.
struct Couplings {
  std::vector<Follower> followers;  // each after its master
  std::vector<FarAxis> far;         // that follow axes of other channels, or are exchanged with them
  Axes lead{};                      // by axis
};

/// The axis of the channel with that number, other than `axis`.
std::optional<std::size_t> axis_numbered(const BlockContext& m, double number, std::size_t axis);

/// An axis of another channel has that number.
bool is_far_axis(const BlockContext& m, double number);

/// What the set-up's events ask for and cannot be: a sentence; empty: all can.
SetupFault coupling_fault(const BlockContext& m, const std::vector<SetupEvent>& events);

/// Gantry axes (N2102 #4 PSN=1) stand where their masters stand, and follow them from now on.
void couple_gantries(BlockContext& m);

/// The machine's logic lets an axis follow the master that N2101 names, or not any more; an axis of another channel is none of ours, but
/// may be the master.
void couple_axis(Emitter& m, const std::string& name, bool on);

/// An axis hangs on one of another channel, or not any more.
void link_far(BlockContext& m, const FarAxis& axis, bool on);

/// alarms  axis_follows: one of the named axes follows another
Status not_following(const BlockContext& m, AxisMask named);

/// The motion's masters stand at its end: the followers get theirs.
void follow(BlockContext& m, Motion& motion);

/// The tool stands elsewhere (a probe has touched, a block is taken back): followers that roll over count on from there.
void follow_from_here(BlockContext& m);

}  // namespace kadr::nct
