#pragma once
// Cutter radius compensation on the control's side, for the controls other than NCT: the order of the blocks around G41, G42, G40, and
// what each motion passes to `path`. 2С42 6.4.7, 6.6.7, 6.8; Mach3 10.7.13; GOST like the 2С42 (INFERRED).

#include "control/emitter.h"

namespace kadr {

/// Puts G41 (side -1) or G42 (+1) in force from the block's motion on. INFERRED: a G40 whose leaving motion has not come yet is cancelled.
///   alarms  compensation_active: the tool is still offset from a contour in another plane
Status begin_compensation(BlockContext& m, const Call& call, std::int8_t side);

/// Returns true while G41 or G42 is in force. After G40 it is false, although the tool may stay offset from the contour until the next
/// motion in its plane: plane, unit and work offset may change there (RS274/NGC: the mode ends with G40).
bool compensates(const Modal& modal);

/// Makes the tool's actual position the programmed position if the tool is still offset from the contour: for codes that refer to "the
/// current point" (G92, G16: Mach3 10.7.27, 10.7.6).
void restart_contour_at_tool(Emitter& m);

/// Records where the tool is at the end of an arc, once the centre of the arc is known.
void note_arc_end(BlockContext& m, const Motion& arc);

/// G40: the next motion in the plane leaves the contour; the block with G40 alone moves nothing.
///   alarms  compensation_two_blocks: the contour has only one block (2С42 6.4.7)
Status end_contour(Emitter& m, const Call& call);

/// For M0 and similar codes: first executes the motions that a queued contour holds back, up to the position offset from the contour's
/// last point (spec/linuxcnc 7.5).
void stop_off_contour(Emitter& m);

/// Returns true if G0 or G1 alone is a motion too: with length zero it begins a queued contour or leaves it.
bool leads_without_words(const BlockContext& m);

/// Checks the motion of a block with axis words before it is executed.
///   alarms  compensation_two_blocks: no motion in the plane between G41, G42 and the second block of the contour (2С42 6.4.7);
///           compensation_closing: G40 in the block that closes the contour (2С42 6.4.7; INFERRED: it ends where the first one ended)
Status contour_allows_motion(const BlockContext& m);

/// Checks a motion along the tool axis only, in a canned cycle or by axis word.
///   alarms  compensation_two_blocks, as above
Status contour_allows_infeed(const BlockContext& m, Span where);

/// Checks that an arc neither approaches nor leaves the contour (INFERRED).
///   alarms  compensation_begins_in_arc, compensation_ends_in_arc
Status check_arc_at_compensation_ends(const BlockContext& m, Span where, std::string_view code);

/// Sets side, radius and corner joint of a motion that is emitted, and updates the progress of cutter compensation.
///   from  start of the motion, work coordinates
void note_compensation(Emitter& m, Motion& motion, const Axes& from);

/// Returns the feed of a motion in inch mode, mm/min or degrees/min. If only rotary axes move, F is in degrees, which are not converted
/// (NIST 2.1.2.5; LinuxCNC, Mach3). `from`: start of the motion.
double feed_in_inches(const BlockContext& m, const Motion& motion, const Axes& from);

}  // namespace kadr
