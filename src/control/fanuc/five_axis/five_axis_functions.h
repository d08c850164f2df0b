#pragma once
// Five-axis functions (chapter 25 of the NCT manual): frames in space, orienting the rotary axes to the tool direction, tool centre point
// control (spec/nct/25a to 25l).

#include <memory>
#include <optional>

#include "action/placement.h"
#include "base/result.h"
#include "control/fanuc/state/five_axis_state.h"

namespace kadr {
class BlockContext;
class Emitter;
class FiveAxisTransform;
struct Call;
struct Motion;
enum class MotionKind : std::uint8_t;
}  // namespace kadr

namespace kadr::fanuc {

/// Returns the transformation between work and machine coordinates that the codes in force define. Returns `before` if nothing has changed.
/// Returns nullptr if the machine has no five-axis kinematics and no programming frame in space is on.
std::shared_ptr<const WorkTransform> five_axis_transform(const Emitter& m, const std::shared_ptr<const WorkTransform>& before);
/// Computes the frames in force (origin, tool length, rotation, programming frame in space) from the modal codes (10, 25). refresh_frames()
/// calls this function.
void refresh_space(Emitter& m);
const FiveAxisTransform* space_of(const BlockContext& m);

/// Makes the block's motion also position the main axes X, Y, Z, at their last programmed coordinates, so that a new tool length or work
/// offset takes effect (25h).
void take_up(BlockContext& m, const Axes& programmed_before);
/// Records which rotary axes the block positions. Once all rotary axes have been positioned, the basic rotation of the work system tilts
/// the tool too (25.20). The caller must call this before it uses the target of the motion.
void note_positioned(Emitter& m, AxisMask named);

/// Prepares a block before it is planned. Replaces the words I J K of G43.5, G43.9 by words of the rotary axes. Reads the surface normal
/// ,L2 I J K and removes its words from the block. Closes the definition of a tilted plane (G68.2 P2, P3) after its last block. Raises an
/// alarm for codes that cannot be combined with tool centre point control.
///   alarms  lead_words, direction_zero, direction_unreachable, lead_state, and those of finish_plane()
Status five_axis_block(Emitter& m);
/// Returns true if five_axis_block() must be called for every block: in the modes in force, I J K or ,L2 may be vectors, or a tilted plane
/// is being defined.
bool watches_words(const BlockContext& m);
/// Returns true if five_axis_block() must be called for this block, because the block may have codes that cannot be combined with tool
/// centre point control.
bool watches_codes(const BlockContext& m);
/// Returns true if tip_control_line() must execute straight motions. This is the case if posture or cutting point control determines the
/// path of the tool tip, or if the basic rotation of the work system tilts the tool.
bool controls_lines(const BlockContext& m);
Status tip_control_line(Emitter& m, const Call& call, MotionKind kind);
/// Completes a motion that was just added in tool centre point control: adds the data of its tip path (25.16, 25.17).
///   alarms  lead_angle, normal_missing
Status control_tip(BlockContext& m, Motion& motion, const Axes& from);

/// Must be called for each block while G68.2 P2 or P3 defines a plane. A block of another kind closes the definition; an incomplete
/// definition then raises an alarm.
Status finish_plane(BlockContext& m);
/// Puts the tool length that an H word selects into force (25b, 25h). `length`: mm.
void register_tip_length(BlockContext& m, double length);
/// Executes a D word: sets tool radius and corner radius for cutting point control (25.17).
void note_tip_radius(BlockContext& m);
/// Checks that G49 may end tool centre point control: a motion in the block of G49 must be G0 or G1 (25.14). INFERRED: the same holds for
/// cutting point control (25.17). alarms lead_mode
Status may_end_tip_control(const BlockContext& m, const Call& call);
/// Ends the modes G43.1 to G43.9. Called for G49, G43, G44, G43.7.
void end_tip_control(BlockContext& m);
/// Ends every five-axis function, as G49, G69.1 and G54 do; used by a reset.
void reset_five_axis(BlockContext& m);

}  // namespace kadr::fanuc
