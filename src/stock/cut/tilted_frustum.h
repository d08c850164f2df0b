#pragma once
// Finds the intervals of lattice lines inside a frustum (a cylinder, or a cone without its apex) of a tilted tool, and inside the volume
// that the frustum sweeps. Used by stock/cut/tilted_rows.

#include "stock/cut/sweep_search.h"
#include "stock/cut/tilted_body.h"
#include "stock/cut/upright_rows.h"

namespace kadr::lanes {

template <class V>
struct Vec3Of {
  V x, y, z;
};
template <class V>
KADR_IN_LANES V dot(const Vec3Of<V>& a, const Vec3Of<V>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class V>
KADR_IN_LANES Vec3Of<V> across(const Vec3Of<V>& a, const Vec3Of<V>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class V>
KADR_IN_LANES Vec3Of<V> plus(const Vec3Of<V>& a, const V& by, const Vec3Of<V>& b) {
  return {a.x + by * b.x, a.y + by * b.y, a.z + by * b.z};
}

// sine² of an angle; a line that makes a smaller angle with an axis counts as parallel to the axis.
inline constexpr float nearly_along = 1e-11f;
inline constexpr float shortest_path = 1e-6f;  // limit in mm; on a shorter path, a tool counts as not moving

/// Returns the value `v` moved away from 0 to at least `by`, so that the result can be a divisor.
template <class V>
KADR_IN_LANES V guarded(const V& v, float by = nearly_none) {
  return choose(v < 0.f, least(v, spread<V>(-by)), most(v, spread<V>(by)));
}

template <class V>
KADR_IN_LANES V inverse(const V& slope) {
  return 1.f / guarded(slope);
}

/// The common direction of all lines of a family, a unit vector in the tool's coordinates.
struct Heading {
  KADR_IN_LANES explicit Heading(const float (&e)[3])
      : x(e[0]),
        y(e[1]),
        z(e[2]),
        per_z(1 / (std::fabs(z) < nearly_none ? nearly_none : z)),
        square(x * x + y * y),
        per_square(1 / std::max(square, nearly_along)) {}
  KADR_IN_LANES bool along_axis() const { return square < nearly_along; }

  float x, y, z;
  float per_z;
  // square: x² + y², the squared length of the component across the tool's axis; per_square: the inverse of `square`.
  float square, per_square;
};
template <class V>
KADR_IN_LANES Vec3Of<V> vector_of(const Heading& h) {
  return {spread<V>(h.x), spread<V>(h.y), spread<V>(h.z)};
}

/// The motion of the tool past lattice lines during the path, without the tool's turn.
template <class V>
struct PathPast {
  Vec3Of<V> travel, forth;  // travel: vector of the motion, mm; forth: unit vector of the motion
  V length, per_flat;
  MarksOf<V> moves, moves_flat;
};

/// Lattice lines with one direction, and the motion of the tool past each line.
template <class V>
struct TiltedLines {
  Heading heading, first, last;  // direction of the lines in the tool's coordinates half way along the path, at its start and at its end
  PathPast<V> past;
};
template <class V>
KADR_IN_LANES PathPast<V> path_past(const Vec3Of<V>& travel) {
  PathPast<V> l;
  const V flat_square = travel.x * travel.x + travel.y * travel.y, square = flat_square + travel.z * travel.z,
          flat = square_root(flat_square);
  l.travel = travel, l.length = square_root(square);
  const V per = 1.f / most(l.length, spread<V>(shortest_path));
  l.forth = {travel.x * per, travel.y * per, travel.z * per};
  l.per_flat = 1.f / most(flat, spread<V>(shortest_path));
  l.moves = square > shortest_path * shortest_path, l.moves_flat = flat > shortest_path;
  return l;
}

/// The middle of a line in the tool's coordinates at the start (`first`) and the end (`last`) of the path. `at` is the position of this
/// middle at the start of the path if the tool only shifted, without a turn.
template <class V>
struct TiltedPosition {
  Vec3Of<V> at, first, last;
};

template <class V>
KADR_IN_LANES Swept<V> everywhere() {
  return {spread<V>(-missed), spread<V>(missed)};
}
template <class V>
KADR_IN_LANES Swept<V> both(const Swept<V>& a, const Swept<V>& b) {
  return {most(a.from, b.from), least(a.to, b.to)};
}
/// Returns the interval from the lesser start to the greater end of two intervals. Both intervals belong to one convex volume, so the
/// volume also contains what is between them.
template <class V>
KADR_IN_LANES Swept<V> either(const Swept<V>& a, const Swept<V>& b) {
  const MarksOf<V> meets = b.from <= b.to;
  return {choose(meets, least(a.from, b.from), a.from), choose(meets, most(a.to, b.to), a.to)};
}

/// Limits each interval of a line to the positions s on the line at which start + s · slope is not negative.
template <class V>
KADR_IN_LANES void clip(Swept<V>& s, const V& start, const V& slope) {
  const V at = -start / guarded(slope);
  const MarksOf<V> rises = slope >= 0.f;
  s = {choose(rises, most(s.from, at), s.from), choose(rises, s.to, least(s.to, at))};
}
/// Limits the intervals to the positions `place` on the line at which start + place * slope is between 0 and `max_value`; `per` is 1 /
/// slope.
template <class V>
KADR_IN_LANES void clip_between(Swept<V>& s, const V& start, const V& max_value, const auto& per) {
  const V a = -start * per, b = (max_value - start) * per;
  s = {most(s.from, least(a, b)), least(s.to, most(a, b))};
}

inline constexpr float nearly_still = 1e-24f;  // limit in mm²; on a path with a smaller squared length, a tool counts as not moving

/// Returns the interval of t in which the point (x, y) + t · (travel_x, travel_y) is inside a circle about the tool's axis. `square` is the
/// squared length of `travel`; if it is less than `none`, the point counts as fixed.
template <class V>
KADR_IN_LANES Swept<V> in_circle(const V& x, const V& y, const V& travel_x, const V& travel_y, const V& square, const V& radius,
                                 float none) {
  const V cross = x * travel_y - y * travel_x, room = radius * radius * square - cross * cross, per = 1.f / most(square, spread<V>(none));
  const V middle = -(x * travel_x + y * travel_y) * per, half = root(room) * per;
  const MarksOf<V> along = square < none, inside = x * x + y * y < radius * radius;
  return {choose(along, choose(inside, spread<V>(-missed), spread<V>(missed)), choose(room > 0.f, middle - half, spread<V>(missed))),
          choose(along, choose(inside, spread<V>(missed), spread<V>(-missed)), choose(room > 0.f, middle + half, spread<V>(-missed)))};
}

/// Returns the interval of a line that is inside a cylinder of unlimited height about the tool's axis. The line is given by the point (x,
/// y) and the direction h.
template <class V>
KADR_IN_LANES Swept<V> in_circle(const V& x, const V& y, const Heading& h, float radius) {
  if (h.along_axis()) {
    const MarksOf<V> inside = x * x + y * y < radius * radius;
    return {choose(inside, spread<V>(-missed), spread<V>(missed)), choose(inside, spread<V>(missed), spread<V>(-missed))};
  }
  const V cross = x * h.y - y * h.x, room = radius * radius * h.square - cross * cross;
  const V middle = -(x * h.x + y * h.y) * h.per_square, half = root(room) * h.per_square;
  return where(room > 0.f, middle - half, middle + half);
}

template <class V>
KADR_IN_LANES Swept<V> in_cylinder(const Vec3Of<V>& at, const Heading& h, const Frustum& f) {
  Swept<V> s = in_circle(at.x, at.y, h, f.low_radius);
  clip_between(s, at.z - f.low, spread<V>(f.high - f.low), h.per_z);
  return s;
}

/// Returns the interval in which the line is inside a cone of unlimited height, whose radius grows by `widens` mm per mm of height.
template <class V>
KADR_IN_LANES Swept<V> in_cone(const Vec3Of<V>& at, const Vec3Of<V>& e, float radius, float bottom, float widens) {
  const V here = spread<V>(radius) + (at.z - bottom) * widens, grows = e.z * widens;
  const V a = e.x * e.x + e.y * e.y - grows * grows, b = at.x * e.x + at.y * e.y - here * grows;
  // The discriminant b² - a c is computed from three squares, in which the common terms of b² and a c have already cancelled.
  const V cross = at.x * e.y - at.y * e.x, u = at.x * grows - here * e.x, v = at.y * grows - here * e.y;
  const V room = u * u + v * v - cross * cross, r = root(room);
  const V c = at.x * at.x + at.y * at.y - here * here, q = -(b + choose(b < 0.f, -r, r));
  const V one = q / guarded(a), other = c / guarded(q), first = least(one, other), last = most(one, other);
  const MarksOf<V> narrow = a >= 0.f, grows_on = grows > 0.f, meets = (room >= 0.f) | (a < 0.f);
  const V from = choose(narrow, first, choose(grows_on, last, spread<V>(-missed)));
  const V to = choose(narrow, last, choose(grows_on, spread<V>(missed), first));
  return where(meets, from, to);
}

/// Shape of the side of a frustum: `straight` is the side of a cylinder, `any` may be that of a cone.
enum class Side { straight, any };

KADR_IN_LANES float widens(const Frustum& f) {
  return f.low_radius == f.high_radius ? 0.f : (f.high_radius - f.low_radius) / (f.high - f.low);
}

/// Numerical error of a flat face in mm. A line in the face to within this error counts as inside the body, because the tool's turn may
/// move the line out of the face exactly at this position.
inline constexpr float in_face = 2e-5f;

template <class V>
KADR_IN_LANES void clip_by_faces(Swept<V>& s, const V& height, const Heading& h, const Frustum& f) {
  clip_between(s, height - (f.low - in_face), spread<V>(f.high - f.low + 2 * in_face), h.per_z);
}

template <class V, Side side>
KADR_IN_LANES Swept<V> in_frustum(const Vec3Of<V>& at, const Heading& h, const Frustum& f) {
  const bool straight = side == Side::straight || widens(f) == 0.f;
  Swept<V> s = straight ? in_circle(at.x, at.y, h, f.low_radius) : in_cone(at, vector_of<V>(h), f.low_radius, f.low, widens(f));
  clip_by_faces(s, at.z, h, f);
  return s;
}

/// Returns the interval of each line that a flat face sweeps by a shift without a turn. The face is a disc across the tool's axis.
template <class V>
KADR_IN_LANES Swept<V> in_shifted_disc(const TiltedLines<V>& l, const Vec3Of<V>& at, float height, float radius) {
  // The point at the position s on the line is in the plane of the face, when the face is at the position t on the path, if s h.z - t way.z
  // = height - at.z. The solutions (s, t) form a straight line; the solution nearest to the origin (0, 0) is computed first.
  const Heading& h = l.heading;
  const Vec3Of<V>& travel = l.past.travel;
  const V square = travel.z * travel.z + h.z * h.z, per = 1.f / most(square, spread<V>(shortest_path * shortest_path)),
          up = (height - at.z) * per;
  const V s = h.z * up, t = -travel.z * up;
  const V x = at.x + s * h.x - t * travel.x, y = at.y + s * h.y - t * travel.y;
  const V travel_x = travel.z * h.x - h.z * travel.x, travel_y = travel.z * h.y - h.z * travel.y;
  Swept<V> in = in_circle(x, y, travel_x, travel_y, travel_x * travel_x + travel_y * travel_y, spread<V>(radius), nearly_still);
  clip_between(in, t, spread<V>(1.f), h.per_z);
  const V a = s + in.from * travel.z, b = s + in.to * travel.z;
  // If neither the motion of the face nor the line has a Z component, the line is in the face at an end of the path or never, so the result
  // is empty.
  return where((in.from <= in.to) & (square > shortest_path * shortest_path) & l.past.moves, least(a, b), most(a, b));
}

/// Returns the interval of each line that the outline of the side sweeps. The outline consists of the two straight lines that bound the
/// side when the frustum is seen along the path.
template <class V>
KADR_IN_LANES Swept<V> in_shifted_outline(const TiltedLines<V>& l, const Vec3Of<V>& at, const Frustum& f) {
  const Heading& e = l.heading;
  const PathPast<V>& p = l.past;
  const V ux = p.travel.x * p.per_flat, uy = p.travel.y * p.per_flat;
  // The outline of the cylinder, as seen along the path, passes a point when the point is exactly to the side of the axis. This happens at
  // the fraction `part` (0 to 1) of the path.
  const V part = (at.x * ux + at.y * uy) * p.per_flat, part_slope = (e.x * ux + e.y * uy) * p.per_flat;
  const V side = at.y * ux - at.x * uy, side_slope = e.y * ux - e.x * uy;
  const V height = at.z - part * p.travel.z, height_slope = e.z - part_slope * p.travel.z;
  Swept<V> s = everywhere<V>();
  clip_between(s, part, spread<V>(1.f), inverse(part_slope));
  clip_between(s, side + f.low_radius, spread<V>(2 * f.low_radius), inverse(side_slope));
  clip_between(s, height - f.low, spread<V>(f.high - f.low), inverse(height_slope));
  return where((s.from <= s.to) & p.moves_flat, s.from, s.to);
}

/// Returns the interval of each line that the outline of a cone sweeps; in_shifted_outline() does the same for a cylinder.
template <class V>
KADR_IN_LANES Swept<V> in_shifted_cone_outline(const TiltedLines<V>& l, const Vec3Of<V>& at, const Frustum& f, float widens) {
  const Heading& e = l.heading;
  const PathPast<V>& p = l.past;
  const V ux = p.travel.x * p.per_flat, uy = p.travel.y * p.per_flat, one = spread<V>(1.f);
  const V facing = p.travel.z * p.per_flat * widens, cosine_square = one - facing * facing, cosine = root(cosine_square);
  const V per = p.per_flat / most(cosine_square, spread<V>(shortest_path));
  // The outline of the cone passes a point at the fraction `part` (0 to 1) of the path at which along - facing · radius(height) = 0. Here
  // `along` is the distance of the point from the axis, measured along the path.
  const V radius = spread<V>(f.low_radius) + (at.z - f.low) * widens;
  const V part = (at.x * ux + at.y * uy - facing * radius) * per, part_slope = (e.x * ux + e.y * uy - facing * (e.z * widens)) * per;
  const V side = at.y * ux - at.x * uy, side_slope = e.y * ux - e.x * uy;
  const V height = at.z - part * p.travel.z, height_slope = e.z - part_slope * p.travel.z;
  const V wide = cosine * (spread<V>(f.low_radius) + (height - f.low) * widens), wide_slope = cosine * height_slope * widens;
  Swept<V> s = everywhere<V>();
  clip_between(s, part, one, inverse(part_slope));
  clip(s, wide - side, wide_slope - side_slope);
  clip(s, wide + side, wide_slope + side_slope);
  clip_between(s, height - f.low, spread<V>(f.high - f.low), inverse(height_slope));
  return where((s.from <= s.to) & p.moves_flat & (cosine_square > shortest_path), s.from, s.to);
}

/// Marks the lines whose distance from the tool's axis may be less than `radius` at some position on the path. A line that is not marked
/// stays on one side of the axis and farther away than `radius`.
template <class V>
KADR_IN_LANES MarksOf<V> come_near(const TiltedLines<V>& l, const Vec3Of<V>& at, float radius) {
  const Heading& h = l.heading;
  const V first = at.x * h.y - at.y * h.x, last = first - (l.past.travel.x * h.y - l.past.travel.y * h.x);
  const float reach = radius * std::sqrt(h.square) + shortest_path;
  return (least(first, last) <= reach) & (most(first, last) >= -reach);
}

/// Whether the lower and the upper flat face of the frustum may enter the brick; a face that cannot is not computed.
struct FacesNear {
  bool low = true, high = true;
};

template <class V, Side side>
KADR_IN_LANES Swept<V> in_frustum_at_ends(const TiltedLines<V>& l, const TiltedPosition<V>& place, const Frustum& f) {
  const Swept<V> first = in_frustum<V, side>(place.first, l.first, f);
  return either(where(first.from <= first.to, first.from, first.to), in_frustum<V, side>(place.last, l.last, f));
}

/// Returns the interval of each line that the frustum sweeps between the poses at the two ends of the path.
template <class V, Side side>
KADR_IN_LANES Swept<V> in_frustum_between(const TiltedLines<V>& l, const Vec3Of<V>& at, const Frustum& f, FacesNear near) {
  Swept<V> s;
  if (side == Side::straight || widens(f) == 0.f) s = in_shifted_outline(l, at, f);
  else s = in_shifted_cone_outline(l, at, f, widens(f));
  if (near.low) s = either(s, in_shifted_disc(l, at, f.low, f.low_radius));
  if (near.high) s = either(s, in_shifted_disc(l, at, f.high, f.high_radius));
  return s;
}

template <class V, Side side>
KADR_IN_LANES Swept<V> in_shifted_frustum(const TiltedLines<V>& l, const TiltedPosition<V>& place, const Frustum& f, FacesNear near) {
  if (!any(come_near(l, place.at, std::max(f.low_radius, f.high_radius)))) return {spread<V>(missed), spread<V>(-missed)};
  return either(in_frustum_at_ends<V, side>(l, place, f), in_frustum_between<V, side>(l, place.at, f, near));
}

}  // namespace kadr::lanes
