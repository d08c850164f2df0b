#pragma once
// Curve: the path of one Motion from where the tool stands: a line, an arc, a spiral, a helix, a cone or a spline; or one of these in the
// plane of a surface: polar or cylinder interpolation. Axes outside the plane, and rotary ones, go evenly along; an axis that
// follows another goes as that does. NIST 2.1.2.3, 2С42 6.6, NCT 4.2–4.6, 20.2, LinuxCNC G5 to G5.3.

#include "action/action.h"
#include "action/axis_roles.h"
#include "action/flat_path.h"
#include "action/polar.h"

namespace kadr {

/// Least and most value of each axis.
struct Extents {
  Axes least;
  Axes most;
};

/// A view of a motion: what it is made of must outlive it. Work coordinates.
///   law  length, extents of a turned, mirrored, reversed motion: the same, turned, mirrored
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
    if (arc_ || motion.detail) find_path();  // else a straight line, of which its ends are all
  }
  Curve(const AxisRoles&, Axes&&, const Motion&) = delete;

  bool arc() const { return arc_; }
  bool spline() const { return spline_; }
  PathSurface surface() const { return surface_; }
  /// A line in the axes: its speed and direction are the same all along.
  bool straight() const { return !arc_ && !spline_ && surface_ == PathSurface::plane; }

  /// Length of the path in mm: of the linear axes; on a surface in its plane. Axes outside the plane count, rotary ones and those
  /// that follow others do not.
  double length() const;

  /// The way of the rotary axes outside the plane in degrees (of several: as if at right angles, NIST 2.1.2.5).
  double rotary_length() const;

  /// Length of what a feed is measured along.
  double length(FeedAlong along) const;

  /// That is certainly length().
  bool measures_path(FeedAlong along) const;

  /// How fast that grows: d length / d part. The same all along but for spirals.
  double rate(FeedAlong along, double part) const;

  /// Signed way of an axis between the ends of the motion; whole turns of an axis that rolls over included.
  double way(std::size_t axis) const { return (rolled_ >> axis & 1U) != 0 ? motion_.detail->travel[axis] : motion_.to[axis] - from_[axis]; }

  /// Point at the part 0..1 of a line's length, of an arc's angle. An axis that rolls over counts on beyond its turn until the end.
  Axes at(double part) const;

  /// How fast the axes move: d at(part) / d part, mm or degrees.
  Axes rates(double part) const;

  /// Those of the two axes of polar interpolation.
  PolarAxes polar_rates(double part) const { return polar().rates(part); }

  /// The same point as the program's words mean it on a surface: polar: mm in the programmed plane; else at(part).
  Axes programmed(double part) const;

  /// Point of a path that is not straight, in its plane; of a surface mm in the programmed or unrolled plane.
  Vec2 flat(double part) const { return flat_.at(part); }

  /// Of a path that is not straight, in its plane: 1/mm, positive where it turns to the left.
  double curvature(double part) const { return flat_.curvature(part); }

  /// The part at which polar interpolation is nearest to the rotation centre; 0 off it.
  double nearest() const;

  /// Bounding box. Of axes that roll over: only the ends.
  Extents extents() const;

  /// Number of equal pieces whose chords stay within `chord` mm of the path; 1 for a line.
  int pieces(double chord) const;

  /// Number of equal pieces with at most one extreme of any axis each: for searches.
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
  AxisMask following_ = 0;              // axes that copy another's way
  std::size_t first_ = 0, second_ = 1;  // axes of the plane
  FlatPath flat_;                       // the path in the plane, of a surface in its own; not set for a straight line
};

}  // namespace kadr
