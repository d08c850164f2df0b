#pragma once
// What a motion tells of its contour in the plane (ContourData): is it an element, what does it lie on. NCT 17.

#include <optional>

#include "action/curve.h"
#include "path/curve/corner_geometry.h"

namespace kadr {

inline const ContourData* contour_of(const Motion& m) { return m.detail && m.detail->contour ? &*m.detail->contour : nullptr; }

/// It begins where the line or circle it lies on meets the motion before.
inline bool is_over_determined(const ContourData* c) {
  return c != nullptr && (c->on == SupportingCurve::line || c->on == SupportingCurve::circle);
}
/// It ends with a chamfer or rounding.
inline bool is_shaped(const ContourData* c) { return c != nullptr && (c->chamfer > 0 || c->rounding > 0); }
/// Only its direction is known.
inline bool is_way(const ContourData* c) { return c != nullptr && c->on == SupportingCurve::way; }

/// G1, G2, G3 in a plane of the axes.
inline bool is_element(const Motion& m) {
  return (m.kind == MotionKind::feed || is_arc(m.kind)) && !(m.detail && m.detail->surface != PathSurface::plane);
}

/// Its end may be calculated by the next motion: that is so while radius compensation is on (17.3).
inline bool may_end_elsewhere(const Motion& m) { return m.side != 0 && is_element(m); }

inline Vec2 in_plane(const Axes& axes, const Motion& of) { return {axes[of.first], axes[of.second]}; }

/// +1 counter-clockwise.
inline double sense_of(const Motion& arc) { return arc.kind == MotionKind::arc_ccw ? 1 : -1; }

/// Nothing that comes after can be looked at before this has been done: codes that empty the buffer (15.5.2), stops, G39, G40 alone.
bool ends_look_ahead(const Action& action);

/// The line or circle that a motion from one point to the other lies on (17.3 rule 9); nothing: a line of no length.
std::optional<Support> support_of(const Motion& motion, Vec2 from, Vec2 end);

/// Swept angle / 360 of an arc whose ends are calculated; a whole turn if they coincide, as in a programmed one (4.3).
double calculated_turns(Vec2 from, Vec2 to, Vec2 center, double sense);

/// A line or a circle's arc, no spiral: a corner with it can be rounded.
bool is_circular(const ContourElement& element);

/// Takes the ContourData out of a motion in the plane.
void without_contour(Motion& motion);

}  // namespace kadr
