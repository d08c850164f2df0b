#pragma once
// Programmed words → end points; work systems, shifts, planes, surfaces of the NCT control (spec/nct/05, 09, 10, 04 4.5–4.6).

#include "base/result.h"
#include "base/vec.h"
#include "control/action.h"

namespace kadr {
class Machinery;
}

namespace kadr::nct {

/// End point by the block's axis words: G90/G91, operator I, U V W, diameter, polar data, roll-over (5.1–5.6).
Status target(const Machinery& m, Axes& to, AxisMask& named);
/// Origin, length, shifts and basic rotation worked out anew (10, position chain).
void refresh_frames(Machinery& m);
/// A motion has been made: travel of rolled axes, feed of mixed axes, the block's kind.
void note_motion(Machinery& m, Motion& motion);
/// A straight motion in the virtual plane (G12.1) or on the cylinder (G7.1).
Status surface_line(Machinery& m, MotionKind kind, const Axes& programmed, AxisMask named);
/// A programmed point in the plane of the surface, mm; the real axes of one; what a motion on a surface has beside its end.
Vec2 flat_point(const Machinery& m, const Axes& programmed);
Axes surface_work(const Machinery& m, const Axes& programmed);
void finish_surface(Machinery& m, Motion& motion, const Axes& from);
/// The detail of a motion, to be filled.
MotionDetail& detail_of(Machinery& m, Motion& motion);
/// First main axis of that role (1, 2, 3 = X, Y, Z), or -1.
int main_axis(const Machinery& m, int role);
/// "XY": names of the plane's axes.
std::string plane_name(const Machinery& m);

}  // namespace kadr::nct
