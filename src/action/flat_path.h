#pragma once
// FlatPath: a line, a circle's arc, a planar spiral or a part of a spline in a plane. NCT 4.3: the radius changes linearly with the angle,
// R(φ) = R0 + (R1 − R0)·φ/Φ, over any number of turns. A `part` 0..1 is that of a line's or spline's length, of an arc's angle.

#include "action/box2.h"
#include "base/vec.h"

namespace kadr {

class PlaneSpline;

/// A circle's arc, counter-clockwise from the end of one arm to that of the other.
struct CircleArc {
  Vec2 center;
  double radius = 0;
  Vec2 first, last;  // from the centre
  double turns = 0;  // swept angle / 360, positive
};

/// Widens the box by the arc's outermost points in the directions of the axes, its ends excepted.
void take_quarters(Box2& box, const CircleArc& arc);

///   law  at(0) is the start and at(1) the end, bit by bit
///   law  turned, mirrored, reversed: the same length; cut in two: the lengths add up
class FlatPath {
 public:
  FlatPath() = default;
  static FlatPath line(Vec2 from, Vec2 to);

  /// `turns`: swept angle / 360, counter-clockwise positive. Where one radius is 0, the other end gives the direction.
  static FlatPath arc(Vec2 from, Vec2 to, Vec2 center, double turns);

  /// `from`, `to`: parts of the curve, which must outlive the path.
  static FlatPath spline(const PlaneSpline& curve, double from, double to);

  bool is_arc() const { return arc_; }

  Vec2 at(double part) const;

  /// How fast the point moves: d at(part) / d part, mm.
  Vec2 rate(double part) const;

  /// Length in mm if it also goes `rise` mm out of the plane, evenly with the part (helix, cone).
  double length(double rise = 0) const;

  /// Of an arc: its angle along a circle of the radius at its start; 0 where that is 0.
  double turn_length() const;

  /// The exact bounding box.
  Box2 box() const;

  /// Angle swept about the plane's origin up to `part`, degrees, signed, whole turns counted.
  /// Through the origin itself: by half a turn.
  double swept(double part) const;

  /// Number of equal pieces whose chords stay within `chord` mm; 1 for a line.
  int pieces(double chord) const;

  /// 1/mm, positive where it turns to the left; of a spiral that of the circle there.
  double curvature(double part) const;

  /// Number of equal pieces with at most one extreme of any coordinate each: for searches.
  int samples() const;

 private:
  double radius(double part) const { return radius_ + radius_change_ * part; }
  double absolute_deg(double part, double radius_at) const;
  double on_spline(double part) const { return spline_from_ + part * (spline_to_ - spline_from_); }

  Vec2 from_, to_;
  Vec2 center_;
  Vec2 arm_;              // centre → start; its direction alone, if the radius there is 0
  double sweep_deg_ = 0;  // counter-clockwise positive
  double radius_ = 0;
  double radius_change_ = 0;  // at the end, against the start
  bool arc_ = false;
  const PlaneSpline* spline_ = nullptr;
  double spline_from_ = 0, spline_to_ = 1;  // parts of the curve
};

}  // namespace kadr
