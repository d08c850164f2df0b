#pragma once
// Chapter 25 of the NCT manual: frames in space, rotary axes in the tool's direction, the tool led by its tip (spec/nct/25a to 25l).

#include <memory>
#include <optional>

#include "action/placement.h"
#include "base/result.h"
#include "control/fanuc/state/five_axis_state.h"

namespace kadr {
class BlockContext;
class Emitter;
class PartSpace;
struct Call;
struct Motion;
enum class MotionKind : std::uint8_t;
}  // namespace kadr

namespace kadr::fanuc {

/// The space of the codes in force; nullptr: there is nothing of chapter 25. The one before, if it is the same.
std::shared_ptr<const WorkSpace> part_space(const Emitter& m, const std::shared_ptr<const WorkSpace>& before);
/// The frames by the codes in force: origin, length, turn and space (10, 25). Called by refresh_frames().
void refresh_space(Emitter& m);
const PartSpace* space_of(const BlockContext& m);

/// The block's axis words position the main axes too, at what they were programmed last: a length, a zero is taken up (25h).
void take_up(BlockContext& m, const Axes& programmed_before);
/// Rotary axes of the block are positioned: from then on the basic rotation leans them too (25.20). Before the motion's target is used.
void note_positioned(Emitter& m, AxisMask named);

/// A block begins. I J K of G43.5, G43.9 and ,L2 I J K are taken out of it: the rotary axes get words instead. A plane of G68.2 P2, P3
/// whose blocks are over is looked at. What does not go together with a tip that is led is refused.
///   alarms  lead_words, direction_zero, direction_unreachable, lead_state, and those of finish_plane()
Status five_axis_block(Emitter& m);
/// That every block must go through the above.
bool watches_words(const BlockContext& m);
/// That the block must: its codes may not go together with the tip that is led.
bool watches_codes(const BlockContext& m);
/// A straight motion while the tip is led along a way of its own, or the basic rotation leans the tool.
bool leads_lines(const BlockContext& m);
Status led_line(Emitter& m, const Call& call, MotionKind kind);
/// A motion has been added that leads the tip: what else is to be said of its way (25.16, 25.17).
///   alarms  lead_angle, normal_missing
Status lead_motion(BlockContext& m, Motion& motion, const Axes& from);

/// G68.2 P2, P3 is complete, or an alarm: the first block that is none of it has come.
Status finish_plane(BlockContext& m);
/// H: the length of it is in force (25b, 25h).
void register_lead_length(BlockContext& m, double length);
/// D: radius and corner radius for the cutting point (25.17).
void note_lead_radius(BlockContext& m);
/// G49 where a tip is led: only with G0 or G1 (25.14; INFERRED: in the modes of 25.17 too). alarms lead_mode
Status may_end_lead(const BlockContext& m, const Call& call);
/// G49, G43, G44, G43.7.
void end_lead(BlockContext& m);
/// G49, G69.1, G54 of a reset: nothing of chapter 25 is in force.
void reset_five_axis(BlockContext& m);

}  // namespace kadr::fanuc
