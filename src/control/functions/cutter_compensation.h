#pragma once
// Cutter compensation in the interpreter, for the controls other than NCT: the order of the blocks around G41, G42, G40, and the data that
// each motion carries for the room path. 2С42 6.4.7, 6.6.7, 6.8; Mach3 10.7.13; GOST like the 2С42 (INFERRED).

#include "control/emitter.h"

namespace kadr {

/// Puts G41 (side -1) or G42 (+1) in force; the motion of the block is the first one under compensation. INFERRED: if the tool is still on
/// the contour since an earlier G40, this G40 has no effect.
///   alarms  compensation_active: the tool is still offset from a contour in another plane
Status begin_compensation(BlockContext& m, const Call& call, std::int8_t side);

/// Returns true while G41 or G42 is in force. After G40 the result is false, although the tool may stay offset from the contour until the
/// next motion in its plane. From G40 on plane, unit and work offset may change (RS274/NGC: the mode ends with G40).
bool compensates(const Modal& modal);

/// If the tool is still offset from a contour after G40, makes the tool's actual position the programmed position. Called by codes that
/// refer to "the current point" (G92, G16: Mach3 10.7.27, 10.7.6).
void restart_contour_at_tool(Emitter& m);

/// Records the direction in which the tool is offset at the end of an arc. To be called when the centre of the arc is known.
void note_arc_end(BlockContext& m, const Motion& arc);

/// Executes G40: the next motion in the plane leaves the contour; a block with only G40 moves nothing.
///   alarms  compensation_two_blocks: the contour has only one block (2С42 6.4.7)
Status end_contour(Emitter& m, const Call& call);

/// Called before M0 and similar codes, on a control that queues compensated motions. Emits the queued motions, so that the tool stops at
/// the position offset from the contour's last point (spec/linuxcnc 7.5).
void stop_off_contour(Emitter& m);

/// Returns true if G0 or G1 without axis words is a motion. This is so on a control that queues compensated motions: a motion of length
/// zero begins or leaves a contour.
bool moves_without_words(const BlockContext& m);

/// Checks the motion of a block with axis words before it is executed.
///   alarms  compensation_two_blocks: there is no motion in the plane between G41 or G42 and the second block of the contour (2С42 6.4.7)
///   compensation_closing: G40 is in the block that closes the contour (2С42 6.4.7; INFERRED: the end point of this block is the end
///     point of the contour's first motion)
Status contour_allows_motion(const BlockContext& m);

/// Checks a motion along the tool axis only; a canned cycle or an axis word commands it.
///   alarms  compensation_two_blocks, as for contour_allows_motion()
Status contour_allows_infeed(const BlockContext& m, Span where);

/// Checks that an arc is neither the first motion of a contour nor the motion that leaves it (INFERRED).
///   alarms  compensation_begins_in_arc, compensation_ends_in_arc
Status check_arc_at_compensation_ends(const BlockContext& m, Span where, std::string_view code);

/// Returns true if the contour has begun, and continues in the plane in force. Then a further motion has the same data of cutter
/// compensation as the motion before, and continue_contour() updates Modal. For MotionDialect::contour_follows().
bool continues_contour(const Modal& modal);

/// Updates Modal after a motion for which continues_contour() was true.
///   from  start of the motion in the plane, work coordinates
void continue_contour(BlockContext& m, const Motion& motion, Vec2 from);

/// Sets the data of cutter compensation (side, radius, type of corner) in a motion to be emitted, and updates Modal::contour.
///   from  start of the motion, work coordinates
void note_compensation(Emitter& m, Motion& motion, const Axes& from);

/// Returns, in mm/min or degrees/min, the feed of a motion that is programmed in inches. If only rotary axes move, F is in degrees per
/// minute and is not converted (NIST 2.1.2.5; LinuxCNC, Mach3). `from`: start of the motion.
double feed_in_inches(const BlockContext& m, const Motion& motion, const Axes& from);

}  // namespace kadr
