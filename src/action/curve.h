#pragma once
// Curve: the path of one Motion from the tool's position: a line, an arc, a spiral, a helix, a cone or a spline, or one of these on a
// surface (polar or cylinder interpolation). Axes outside the plane, and rotary axes, move evenly with the path; a follower axis moves as
// its master does. NIST 2.1.2.3, 2С42 6.6, NCT 4.2–4.6, 20.2, LinuxCNC G5 to G5.3.

#include "action/action.h"
#include "action/axis_roles.h"
#include "action/flat_path.h"
#include "action/polar.h"

namespace kadr {

/// The least and greatest value of each axis.
struct Extents {
  Axes least;
  Axes most;
};

/// A view of a motion, in work coordinates. The constructor's arguments must outlive the view.
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
    if (arc_ || motion.detail) find_path();  // otherwise the motion is a straight line, which its ends determine
  }
  Curve(const AxisRoles&, Axes&&, const Motion&) = delete;

  bool arc() const { return arc_; }
  bool spline() const { return spline_; }
  PathSurface surface() const { return surface_; }
  /// Returns true for a line in axis coordinates: speed and direction are constant.
  bool straight() const { return !arc_ && !spline_ && surface_ == PathSurface::plane; }

  /// Returns the length of the path in mm. It counts the linear axes, also those outside the plane; on a surface, the path is measured in
  /// the surface's plane. Rotary axes and followers do not count.
  double length() const;

  /// Returns the travel of the rotary axes outside the plane, in degrees (several axes: as if at right angles, NIST 2.1.2.5).
  double rotary_length() const;

  /// Returns the length of the motion as the commanded feed measures it. `along` says which travel the feed counts.
  double length(FeedAlong along) const;

  /// Returns true if length(along) certainly equals length(). After false, the caller has to compute both: they may differ.
  bool measures_path(FeedAlong along) const;

  /// Returns d length(along) / d part. It is constant except on spirals.
  double rate(FeedAlong along, double part) const;

  /// Returns the signed travel of an axis over the motion. For a rotary axis that rolls over at 360°, whole revolutions are included.
  double way(std::size_t axis) const { return (rolled_ >> axis & 1U) != 0 ? motion_.detail->travel[axis] : motion_.to[axis] - from_[axis]; }

  /// Returns the point at `part`, 0..1 of a line's length or of an arc's angle. Inside the motion, a rotary axis that rolls over counts on
  /// beyond 360°.
  Axes at(double part) const;

  /// Returns the derivative of at() by `part`, mm or degrees.
  Axes rates(double part) const;

  /// Returns the derivatives of the two axes of polar interpolation.
  PolarAxes polar_rates(double part) const { return polar().rates(part); }

  /// Returns the point at `part` in the coordinates that the program's words have: in polar interpolation mm in the programmed plane, else
  /// at(part).
  Axes programmed(double part) const;

  /// Returns the point in the plane of a path that is not straight; on a surface, mm in the programmed or unrolled plane.
  Vec2 flat(double part) const { return flat_.at(part); }

  /// Returns the curvature of a path that is not straight, in its plane: 1/mm, positive for a left turn.
  double curvature(double part) const { return flat_.curvature(part); }

  /// Returns the part at which polar interpolation is nearest to the rotation centre; 0 without polar interpolation.
  double nearest() const;

  /// Returns the bounding box. Of an axis that rolls over at 360°, only its positions at the start and the end count.
  Extents extents() const;

  /// Returns the number of equal pieces whose chords stay within `chord` mm of the path; 1 for a line.
  int pieces(double chord) const;

  /// Returns a number of equal pieces of the path, so many that each axis has at most one extreme in each piece; for searches.
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
      const double w = way(static_cast<std::size_t>(__builtin_ctz(axes)));
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
  FlatPath flat_;                       // the path in its plane or on its surface; not set for a straight line
};

}  // namespace kadr
