#pragma once
// ,C ,R ,A and over-determined blocks (spec/nct/17): end points by an angle; what path/contour/contour_corners is told of the others.

#include "action/action.h"
#include "base/result.h"
#include "base/vec.h"

namespace kadr {
class BlockContext;
class Emitter;
struct Call;
}  // namespace kadr

namespace kadr::fanuc {

/// ,C ,R ,A or Q stands in the block; ,C or ,R does.
bool has_geometry_words(const BlockContext& m);
bool has_shape_words(const BlockContext& m);

/// Words on the two axes of the plane.
struct PlaneWords {
  bool first = false, second = false;
  bool both() const { return first && second; }
  bool one() const { return first != second; }
};
PlaneWords plane_words(const BlockContext& m);

/// The other coordinate of the plane by ,A, where one is given (17.2); with none or both: nothing.
///   alarms  angle_meets_not; position_out_of_range; not_together: G16
Status end_by_angle(const BlockContext& m, Axes& to, AxisMask& named);

/// ,A beside one coordinate of the plane: what a drilling cycle wants (17.2). alarms  angle_alone
Status one_coordinate(const BlockContext& m);

/// G0, G1 with words of this chapter.
///   alarms  those of end_by_angle and shape_words; angle_alone, intersection_needs_side, illegal_address (Q), surface_state
Status shaped_line(Emitter& m, const Call& call, MotionKind kind);

/// ,C and ,R of the block.
///   alarms  chamfer_and_rounding (2082), value_out_of_range
Status shape_words(const BlockContext& m, ContourData& contour);

/// X Y I J R of an arc in G41, G42: the second of two blocks that meet at a calculated point (17.3.2, 17.3.4).
///   alarms  intersection_needs_side, illegal_address (Q)
Result<bool> is_over_determined_arc(const BlockContext& m, bool has_both_centers);
/// Its circle: the centre absolute, R its radius.
///   alarms  radius_mismatch (2012), value_out_of_range
Status circle_words(const BlockContext& m, Vec2 center, Vec2 end, ContourData& contour);

/// Tells `path` of the last motion's contour.
void attach(Emitter& m, const ContourData& contour);

}  // namespace kadr::fanuc
