#pragma once
// Automatic geometry (spec/nct/17): chamfers ,C, roundings ,R, angles ,A and over-determined blocks. This file computes end points given by
// an angle; path/compensation/corner_resolver computes everything else.

#include "action/action.h"
#include "base/result.h"
#include "base/vec.h"

namespace kadr {
class BlockContext;
class Emitter;
struct Call;
}  // namespace kadr

namespace kadr::fanuc {

/// has_geometry_words() returns true if the block has ,C ,R ,A or Q. has_shape_words() returns true if the block has a chamfer ,C or a
/// rounding ,R.
bool has_geometry_words(const BlockContext& m);
bool has_shape_words(const BlockContext& m);
/// Returns true if the block of a lathe has I, K or R, which in G1 are a chamfer or a rounding (spec/fanuc-t 3.4).
bool has_corner_words(const BlockContext& m);

/// Lets the words C, R and A of a lathe's G1 mean ,C ,R ,A if parameter 3405#4 CCR is set. C and A are axes where the channel has them
/// (spec/fanuc-t 3.4).
void take_corner_letters(BlockContext& m);

/// Which of the two axes of the plane have a word in the block.
struct PlaneWords {
  bool first = false, second = false;
  bool both() const { return first && second; }
  bool one() const { return first != second; }
};
PlaneWords plane_words(const BlockContext& m);

/// Computes the second coordinate of the plane from ,A if one coordinate is given (17.2). Does nothing if the block gives neither or both
/// coordinates.
///   alarms  angle_meets_not; position_out_of_range; not_together: G16
Status end_by_angle(const BlockContext& m, Axes& to, AxisMask& named);

/// Checks that ,A comes with exactly one coordinate of the plane, as a drilling cycle requires (17.2). alarms  angle_alone
Status one_coordinate(const BlockContext& m);

/// Executes G0 or G1 with the words ,C ,R ,A or Q (chapter 17).
///   alarms  those of end_by_angle and shape_words; angle_alone, intersection_needs_side, illegal_address (Q), surface_state;
///           corner_at_side_change: a corner of a lathe at the start or the end of compensation
Status shaped_line(Emitter& m, const Call& call, MotionKind kind);

/// Reads ,C and ,R of the block.
///   alarms  chamfer_and_rounding (2082), value_out_of_range
Status shape_words(const BlockContext& m, CornerData& contour);

/// Returns true if the block is an over-determined arc, X Y I J R in G41, G42. This arc is the second of two blocks that meet at a computed
/// point (17.3.2, 17.3.4).
///   alarms  intersection_needs_side, illegal_address (Q)
Result<bool> is_over_determined_arc(const BlockContext& m, bool has_both_centers);
/// Reads the circle of an over-determined arc. `center`: centre of the circle, an absolute position; word R is the radius.
///   alarms  radius_mismatch (2012), value_out_of_range
Status circle_words(const BlockContext& m, Vec2 center, Vec2 end, CornerData& contour);

/// Attaches corner data to the last motion. The room `path` computes chamfers, roundings and intersections from these data.
void attach(Emitter& m, const CornerData& contour);

}  // namespace kadr::fanuc
