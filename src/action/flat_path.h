#pragma once
// FlatPath: a line, a circular arc, a planar spiral or a segment of a spline in a plane. The radius of a spiral changes linearly with the
// angle (NCT 4.3): R(φ) = R0 + (R1 − R0)·φ/Φ, over any number of revolutions. A `part` is a fraction (0 to 1) of the length of a line or
// spline, or of the angle of an arc.

#include "action/box2.h"
#include "base/vec.h"

namespace kadr {

class PlaneSpline;

/// A circular arc, counter-clockwise from the point centre + `first` to the point centre + `last`.
struct CircleArc {
  Vec2 center;
  double radius = 0;
  Vec2 first, last;  // vectors from the centre to the two ends of the arc
  double turns = 0;  // angle swept by the arc, divided by 360°; positive
};

/// Extends the box to the points at which the arc's tangent is parallel to an axis. The caller has to add the arc's ends.
void take_quarters(Box2& box, const CircleArc& arc);

///   law  at(0) is the start and at(1) the end, bit by bit
///   law  a rotated, mirrored or reversed path has the same length; the lengths of the two parts of a divided path add up to its length
class FlatPath {
 public:
  FlatPath() = default;
  static FlatPath line(Vec2 from, Vec2 to);

  /// Returns an arc. `turns`: swept angle / 360, counter-clockwise positive. If the radius at one end is 0, the vector to the other end
  /// gives the direction.
  static FlatPath arc(Vec2 from, Vec2 to, Vec2 center, double turns);

  /// Returns the segment of a curve between `from` and `to`, which are fractions (0 to 1) of its length. The curve must exist longer than
  /// the path.
  static FlatPath spline(const PlaneSpline& curve, double from, double to);

  bool is_arc() const { return arc_; }

  Vec2 at(double part) const;

  /// Returns the derivative of at() by `part`, mm.
  Vec2 rate(double part) const;

  /// Returns the length in mm. If `rise` is not 0, the path also moves `rise` mm out of the plane, in proportion to `part` (helix, cone).
  double length(double rise = 0) const;

  /// Returns the length of a circular arc that has the path's angle and start radius; 0 if the start radius is 0, or if the path is no arc.
  double turn_length() const;

  /// Returns the exact bounding box of the path.
  Box2 box() const;

  /// Returns the angle, seen from the plane's origin, that the path sweeps up to `part`: signed degrees, with whole revolutions. A path
  /// through the origin sweeps 180° at the origin.
  double swept(double part) const;

  /// Returns the number of equal parts whose chords stay within `chord` mm of the path; 1 for a line.
  int pieces(double chord) const;

  /// Returns the curvature in 1/mm, positive for a left turn. For a spiral, it is approximated by the inverse of the radius at this point.
  double curvature(double part) const;

  /// Returns a number of equal parts of the path, large enough that each coordinate has at most one extreme in each part; for searches.
  int samples() const;

 private:
  double radius(double part) const { return radius_ + radius_change_ * part; }
  double absolute_deg(double part, double radius_at) const;
  double on_spline(double part) const { return spline_from_ + part * (spline_to_ - spline_from_); }

  Vec2 from_, to_;
  Vec2 center_;
  Vec2 arm_;              // vector from the centre to the start; a unit vector if the start radius is 0
  double sweep_deg_ = 0;  // swept angle in degrees, counter-clockwise positive
  double radius_ = 0;
  double radius_change_ = 0;  // radius at the end minus radius at the start, mm
  bool arc_ = false;
  const PlaneSpline* spline_ = nullptr;
  double spline_from_ = 0, spline_to_ = 1;  // the segment's start and end, as fractions (0 to 1) of the spline's length
};

}  // namespace kadr
