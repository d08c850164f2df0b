#pragma once
// Curve: the path of one Motion from the tool's position: a line, an arc, a spiral, a helix, a cone or a spline, or one of these on a
// surface (polar or cylindrical interpolation). Axes outside the plane and rotary axes move evenly along the path; a follower axis copies
// its master. NIST 2.1.2.3, 2С42 6.6, NCT 4.2–4.6, 20.2, LinuxCNC G5 to G5.3.

#include "action/action.h"
#include "action/axis_roles.h"
#include "action/flat_path.h"
#include "action/polar.h"

namespace kadr {

/// The least and the greatest position of each axis.
struct Extents {
  Axes least;
  Axes most;
};

/// The path of one motion, in work coordinates. A Curve refers to the constructor's arguments, which must exist longer than the Curve.
///   law  a rotated, mirrored or reversed motion has the same length, and its extents are rotated or mirrored in the same way
///   law  at(0) is the start and at(1) the end, bit by bit
class Curve {
 public:
  Curve(const AxisRoles& roles, const Axes& from, const Motion& motion)
      : roles_(roles),
        from_(from),
        motion_(motion),
        arc_(is_arc(motion.kind)),
        spline_(motion.kind == MotionKind::spline),
        first_(motion.first),
        second_(motion.second) {
    if (arc_ || motion.detail) find_path();  // a straight line needs no path in the plane, because its two ends suffice
  }
  Curve(const AxisRoles&, Axes&&, const Motion&) = delete;

  bool arc() const { return arc_; }
  bool spline() const { return spline_; }
  PathSurface surface() const { return surface_; }
  /// Returns true for a line in axis coordinates, along which speed ratios of the axes and direction are constant.
  bool straight() const { return !arc_ && !spline_ && surface_ == PathSurface::plane; }

  /// Returns the length of the path in mm. The linear axes count, including those outside the plane; rotary axes and followers do not. On a
  /// surface, the path is measured in the plane of the surface.
  double length() const;

  /// Returns the travel of the rotary axes outside the plane, in degrees. The travels of several axes are added like components at right
  /// angles (NIST 2.1.2.5).
  double rotary_length() const;

  /// Returns the length of the motion as the commanded feed counts it, mm or degrees. `along` selects the travel that counts: for example,
  /// FeedAlong::all_axes counts the travel of all axes.
  double length(FeedAlong along) const;

  /// Returns true if, for this motion, the length that the feed counts in the way `along` equals the length of the path in mm. If the
  /// result is false, the two lengths may differ, and the caller has to compute both: length(along) and length().
  bool measures_path(FeedAlong along) const;

  /// Returns the derivative by `part` (fraction of the motion, 0 to 1) of the length that the feed counts in the way `along`. The
  /// derivative is constant except on spirals.
  double rate(FeedAlong along, double part) const;

  /// Returns the signed travel of an axis over the motion. For a rotary axis that rolls over at 360°, whole revolutions are included.
  double travel(std::size_t axis) const {
    return (rolled_ >> axis & 1U) != 0 ? motion_.detail->travel[axis] : motion_.to[axis] - from_[axis];
  }

  /// Returns the axis positions at `part`, a fraction (0 to 1) of a line's length or of an arc's angle. Inside the motion, the position of
  /// a rotary axis that rolls over continues beyond 360°.
  Axes at(double part) const;

  /// Returns the derivative of the axis positions by `part`, a fraction (0 to 1) of the motion: mm or degrees per unit of `part`.
  Axes rates(double part) const;

  /// Returns the derivatives by `part` of the positions of the linear and the rotary axis of polar interpolation.
  PolarAxes polar_rates(double part) const { return polar().rates(part); }

  /// Returns the point at `part` in the coordinates that the program's words have. In polar interpolation these are mm in the programmed
  /// plane; otherwise they are those of at(part).
  Axes programmed(double part) const;

  /// Returns the point at `part` in the plane of a path that is not a straight line. On a surface, the result is in mm in the programmed or
  /// unrolled plane.
  Vec2 flat(double part) const { return flat_.at(part); }

  /// Returns the curvature of a path that is not straight, in its plane: 1/mm, positive for a left turn.
  double curvature(double part) const { return flat_.curvature(part); }

  /// Returns the `part` (0 to 1) at which polar interpolation is nearest to the rotation centre; 0 without polar interpolation.
  double nearest() const;

  /// Returns the bounding box of the motion. For an axis that rolls over at 360°, the box contains only its positions at the start and the
  /// end.
  Extents extents() const;

  /// Returns the number of equal parts of the path whose chords stay within `chord` mm of the path; 1 for a line.
  int pieces(double chord) const;

  /// Returns a number of equal parts of the path, large enough that each axis has at most one extreme in each part; for searches.
  int samples() const { return straight() ? 1 : flat_.samples(); }

 private:
  AxisMask plane_axes() const { return straight() ? 0 : AxisMask{1} << first_ | AxisMask{1} << second_; }
  AxisMask all_axes() const { return (AxisMask{1} << roles_.count) - 1; }
  AxisMask xyz_axes() const;
  AxisMask own_axes() const { return all_axes() & ~following_; }
  void find_path();
  FlatPath plane_path() const;
  double squares(AxisMask axes) const {
    double sum = 0;
    for (; axes != 0; axes &= axes - 1) {
      const double w = travel(static_cast<std::size_t>(__builtin_ctz(axes)));
      sum += w * w;
    }
    return sum;
  }
  double rise(FeedAlong along) const;
  PolarPath polar() const;
  double unit(std::size_t axis) const;
  Vec2 in_axes(Vec2 flat) const;
  void set_in_plane(Axes& point, Vec2 flat) const;
  void set_followers(Axes& point, double part) const;

  const AxisRoles& roles_;
  const Axes& from_;
  const Motion& motion_;
  bool arc_ = false, spline_ = false;
  PathSurface surface_ = PathSurface::plane;
  AxisMask rolled_ = 0;
  AxisMask following_ = 0;              // mask of the follower axes, which copy another axis' travel
  std::size_t first_ = 0, second_ = 1;  // axes of the plane
  FlatPath flat_;                       // the path in its plane or on its surface; not set if the motion is a straight line
};

}  // namespace kadr
