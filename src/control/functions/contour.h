#pragma once
// Cutter radius compensation on the control's side, for the controls other than NCT: the order of the blocks around G41, G42, G40, and what
// each motion tells `path`. 2С42 6.4.7, 6.6.7, 6.8; Mach3 10.7.13; GOST as the 2С42 (INFERRED).

#include "control/emitter.h"

namespace kadr {

/// G41 (side -1), G42 (+1) are in force from the block's motion on. INFERRED: after a G40 that has not led off the contour yet, as
/// if that had not been.
///   alarms  compensation_active: the tool still stands beside a contour of another plane
Status begin_contour(BlockContext& m, const Call& call, std::int8_t side);

/// G41, G42 are in force. After G40 they are not, though the tool may still stand beside the contour until the next motion in its
/// plane: plane, unit and zero may change there (RS274/NGC: the mode ends with G40).
bool compensates(const Modal& modal);

/// Where the tool still stands beside the contour, that place becomes the programmed one: for codes that mean "the current point"
/// (G92, G16: Mach3 10.7.27, 10.7.6).
void take_up_contour(Emitter& m);

/// An arc has its centre: where the tool stands at its end.
void note_arc_end(BlockContext& m, const Motion& arc);

/// G40: the next motion in the plane leads off the contour; alone it moves nothing.
///   alarms  compensation_two_blocks: one block of the contour only (2С42 6.4.7)
Status end_contour(Emitter& m, const Call& call);

/// M0 and its like: what a queued contour holds back is carried out first, up to beside its point (spec/linuxcnc 7.5).
void stop_beside_contour(Emitter& m);

/// G0, G1 alone are motions too: of no length, they begin a queued contour or lead off it.
bool leads_without_words(const BlockContext& m);

/// Before the motion of a block that is written with axis words.
///   alarms  compensation_two_blocks: no motion in the plane between G41, G42 and the second block of the contour (2С42 6.4.7);
///           compensation_closing: G40 in the block that closes the contour (2С42 6.4.7; INFERRED: it ends where the first one ended)
Status contour_allows_motion(const BlockContext& m);

/// A motion along the tool alone, by a cycle or its block.
///   alarms  compensation_two_blocks, as above
Status contour_allows_infeed(const BlockContext& m, Span where);

/// An arc leads neither onto the contour nor off it (INFERRED).
///   alarms  compensation_begins_in_arc, compensation_ends_in_arc
Status arc_beside_contour(const BlockContext& m, Span where, std::string_view code);

/// Side, radius and joint of a motion that is emitted; counts the blocks of the contour.
///   from  work coordinates at its beginning
void note_contour(Emitter& m, Motion& motion, const Axes& from);

/// The feed of a motion from there while inches are in force, mm/min or degrees/min: where only rotary axes move, F counts degrees, and
/// degrees are no inches (NIST 2.1.2.5; LinuxCNC, Mach3).
double feed_in_inches(const BlockContext& m, const Motion& motion, const Axes& from);

}  // namespace kadr
