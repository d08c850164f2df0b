#pragma once
// Programmed words → end points; work systems, shifts, planes, surfaces (spec/nct/05, 09, 10, 04 4.5–4.6).

#include "action/action.h"
#include "base/result.h"
#include "base/vec.h"
#include "control/fanuc/state/settings.h"
#include "lang/block/block.h"

namespace kadr {
class BlockContext;
class Emitter;
}  // namespace kadr

namespace kadr::fanuc {

/// End point by the block's axis words: G90/G91, operator I, U V W, diameter, polar data, roll-over (5.1–5.6).
Status target(const BlockContext& m, Axes& to, AxisMask& named);
/// Value of an axis word in mm or degrees; a diameter as a radius.
double coordinate(const BlockContext& m, const Word& w, std::size_t axis);
/// The axis is programmed in diameter (5.3).
bool is_diameter(const BlockContext& m, std::size_t axis);
/// By G91, the operator I or an address of increments.
bool is_increment(const BlockContext& m, const Word& w);
/// Origin, length, shifts and basic rotation worked out anew (10, position chain).
void refresh_frames(Emitter& m);
Axes shift_of_origin(const BlockContext& m);
/// c in [0, period).
double rolled_position(double c, double period);
/// Signed way of a rotary axis that rolls over (5.6), from c in [0, R) to the programmed value.
double roll_travel(const AxisSettings& axis, double c, double programmed, bool increment);
/// Axes that roll over are shown in [0, R) (5.6). Machine positions change with a motion only: the machine follows those.
void roll_positions(const BlockContext& m, Axes& positions);
/// A motion has been made: travel of rolled axes, feed of mixed axes, the block's kind.
void note_motion(Emitter& m, Motion& motion);
/// Feed of a motion in inches mode: degrees are not converted, so the way counts in inches and degrees (4.2, 6.2.1).
double inch_feed(const BlockContext& m, const Motion& motion, const Axes& from);
/// A straight motion in the virtual plane (G12.1) or on the cylinder (G7.1).
Status surface_line(Emitter& m, MotionKind kind, const Axes& programmed, AxisMask named);
/// The number in an H or D word; N2923 means that of the tool in the spindle.
Result<std::uint32_t> offset_number(const BlockContext& m, char letter);
/// A point in the plane of the surface, mm; the real axes of a programmed one; what a motion on a surface has beside its end.
Vec2 flat_point(const BlockContext& m, const Axes& point);
Axes surface_work(const BlockContext& m, const Axes& programmed);
/// The same of a point after the transformations, in polar interpolation: the angle is the one nearest to `near` degrees.
Axes polar_work(const BlockContext& m, const Axes& point, double near);
/// An arc in the plane of polar interpolation; turns counter-clockwise positive.
struct FlatArc {
  Vec2 from, to, center;
  double turns = 0;
};
/// Degrees that the point's direction from the pole turns by on its way, whole turns included (4.5).
double swept_about_pole(const FlatArc& arc);
/// A programmed point after mirroring, scaling and rotation (16.0).
Axes transformed(const BlockContext& m, const Axes& programmed);
/// Where the tool stands after the transformations: work coordinates, in polar interpolation the virtual ones.
Axes before_transform(const BlockContext& m);
void finish_surface(BlockContext& m, Motion& motion, const Axes& from);
/// The detail of a motion, to be filled.
MotionDetail& detail_of(BlockContext& m, Motion& motion);
/// First main axis of that role (1, 2, 3 = X, Y, Z), or -1.
int main_axis(const BlockContext& m, int role);
/// "XY": names of the plane's axes.
std::string plane_name(const BlockContext& m);

}  // namespace kadr::fanuc
