#pragma once
// Converts programmed words to end points; handles work systems, shifts, planes, polar and cylindrical interpolation (spec/nct/05, 09, 10,
// 04 4.5–4.6). An axis that rolls over is a rotary axis whose position restarts at 0 after each full period, usually 360° (5.6).

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

/// Computes the end point from the block's axis words. It considers G90 and G91, the operator I (incremental), incremental addresses U V W,
/// diameter programming, polar data, and axes that roll over (5.1–5.6).
Status target(const BlockContext& m, Axes& to, AxisMask& named);
/// Returns the value of an axis word in mm or degrees; the value of a diameter is halved.
double coordinate(const BlockContext& m, const Word& w, std::size_t axis);
/// Returns true if the axis is in diameter programming (5.3).
bool is_diameter(const BlockContext& m, std::size_t axis);
/// Returns true if the word is an increment: because of G91, the operator I, or an address that is always incremental.
bool is_increment(const BlockContext& m, const Word& w);
/// Computes again the origin, tool length, shifts and basic rotation of the frames in force (NCT manual, chapter 10).
void refresh_frames(Emitter& m);
Axes shift_of_origin(const BlockContext& m);
/// Returns the position `c` of an axis that rolls over, reduced to [0, period) degrees.
double rolled_position(double c, double period);
/// Returns the signed travel in degrees of a rotary axis that rolls over (5.6), from position c in [0, period) to the programmed value.
double roll_travel(const AxisSettings& axis, double c, double programmed, bool increment);
/// Reduces positions of axes that roll over to [0, period) (5.6). The caller may store reduced machine positions only after a motion,
/// because the machine derives its position from the motions.
void roll_positions(const BlockContext& m, Axes& positions);
/// Adds to a new motion what the modes in force require: travel of axes that roll over, common feed of linear and rotary axes, exact stop,
/// cutter compensation.
void note_motion(Emitter& m, Motion& motion);
/// Returns the feed of a motion in inch mode, along a path measured in mm and degrees. In the programmed feed, an inch of a linear axis and
/// a degree of a rotary axis count alike (4.2, 6.2.1).
double inch_feed(const BlockContext& m, const Motion& motion, const Axes& from);
/// Adds a straight motion in polar interpolation (in the virtual plane of G12.1) or in cylindrical interpolation (on the cylinder of G7.1).
Status surface_line(Emitter& m, MotionKind kind, const Axes& programmed, AxisMask named);
/// Returns the offset number of an H or D word. A word with the value of parameter N2923 means the offset of the tool in the spindle.
Result<std::uint32_t> offset_number(const BlockContext& m, char letter);
/// Functions for polar and cylindrical interpolation. flat_point() returns a point in mm in the virtual plane or on the unrolled cylinder.
/// surface_work() returns the positions of the real axes for a programmed point. finish_surface() adds the data of the interpolation to a
/// motion.
Vec2 flat_point(const BlockContext& m, const Axes& point);
Axes surface_work(const BlockContext& m, const Axes& programmed);
/// Returns the positions of the real axes in polar interpolation, for a point after mirroring, scaling and rotation. Several angles that
/// differ by full revolutions are possible; the angle nearest to `near` (degrees) is used.
Axes polar_work(const BlockContext& m, const Axes& point, double near);
/// An arc in the virtual plane of polar interpolation, mm. `turns`: number of revolutions, positive if counter-clockwise.
struct FlatArc {
  Vec2 from, to, center;
  double turns = 0;
};
/// Returns the angle in degrees through which the line from the pole to the tool turns while the tool moves along the arc (4.5). Full
/// revolutions count too.
double swept_about_pole(const FlatArc& arc);
/// Returns a programmed point after mirroring, scaling and rotation (16.0).
Axes transformed(const BlockContext& m, const Axes& programmed);
/// Returns the tool's position after mirroring, scaling and rotation: work coordinates; in polar interpolation, coordinates of the
/// virtual plane.
Axes before_transform(const BlockContext& m);
void finish_surface(BlockContext& m, Motion& motion, const Axes& from);
/// Checks that no tool radius is compensated on a surface, which Kadr cannot do. alarms not_available
Status uncompensated_surface(const BlockContext& m);
/// Gives the motion a MotionDetail that no other motion shares, and returns this MotionDetail, so that the caller can change it.
MotionDetail& detail_of(BlockContext& m, Motion& motion);
/// Returns the index of the first axis of the channel with this role (1, 2, 3 mean X, Y, Z), or -1.
int main_axis(const BlockContext& m, int role);
/// Returns the names of the plane's axes, such as "XY".
std::string plane_name(const BlockContext& m);

}  // namespace kadr::fanuc
