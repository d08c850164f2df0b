#pragma once
// This file answers questions about the contour data (CornerData) of a motion in the plane: whether the motion is a contour element, and on
// which line or circle the motion lies (NCT 17).

#include <optional>

#include "action/curve.h"
#include "path/curve/corner_geometry.h"

namespace kadr {

inline const CornerData* contour_of(const Motion& m) { return m.detail && m.detail->contour ? &*m.detail->contour : nullptr; }

/// True if the motion lies on a fully defined line or circle. The motion starts where this line or circle meets the previous motion.
inline bool is_over_determined(const CornerData* c) {
  return c != nullptr && (c->on == SupportingCurve::line || c->on == SupportingCurve::circle);
}
/// True if the motion ends with a chamfer or rounding. A chamfer below 0 states the length of the chamfer itself, not of its legs.
inline bool is_shaped(const CornerData* c) { return c != nullptr && (c->chamfer != 0 || c->rounding > 0); }
/// True if the program states only the direction of the motion and not its end.
inline bool has_only_direction(const CornerData* c) { return c != nullptr && c->on == SupportingCurve::ray; }

/// True for G1, G2 and G3, unless they are on a polar or cylindrical surface.
inline bool is_element(const Motion& m) {
  return (m.kind == MotionKind::feed || is_arc(m.kind)) && !(m.detail && m.detail->surface != PathSurface::plane);
}

/// True if the next motion may determine the end of this motion. This is possible only while cutter compensation is on (NCT 17.3).
inline bool may_end_elsewhere(const Motion& m) { return m.side != 0 && is_element(m); }

inline Vec2 in_plane(const Axes& axes, const Motion& of) { return {axes[of.first], axes[of.second]}; }

/// Returns +1 for a counter-clockwise arc and −1 for a clockwise arc.
inline double sense_of(const Motion& arc) { return arc.kind == MotionKind::arc_ccw ? 1 : -1; }

/// Returns true for actions that the control must execute before it reads later blocks: codes that empty the look-ahead buffer (NCT
/// 15.5.2), stops, G39, and G40 alone in its block.
bool ends_look_ahead(const Action& action);

/// Returns the line or circle on which a motion between two points lies (NCT 17.3 rule 9). Returns nullopt for a line of zero length.
std::optional<Support> support_of(const Motion& motion, Vec2 from, Vec2 end);

/// Returns the swept angle / 360 of an arc whose ends are calculated. If the ends coincide, the arc is a full circle, as a programmed arc
/// is (NCT 4.3).
double calculated_turns(Vec2 from, Vec2 to, Vec2 center, double sense);

/// Returns true for a line or a circular arc, and false for a spiral (an arc whose radius changes). A corner with a spiral cannot be
/// rounded.
bool is_circular(const ContourElement& element);

/// Removes the CornerData from a motion in the plane.
void without_corner_data(Motion& motion);

}  // namespace kadr
