#pragma once
// Curve: the path of one Motion from where the tool stands: a line, an arc, or a helix; rotary axes go linearly along.
// NIST 2.1.2.3, 2С42 6.6; planes XY, ZX, YZ: the first axis turns to the second counter-clockwise.

#include "path/axis_roles.h"

namespace kadr {

inline bool is_arc(MotionKind kind) { return kind == MotionKind::arc_cw || kind == MotionKind::arc_ccw; }

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
  Curve(const AxisRoles& roles, const Axes& from, const Motion& motion);

  bool arc() const { return arc_; }

  /// Length of the path of the linear axes in mm.
  double length() const;

  /// The way of the rotary axes in degrees (of several: as if at right angles, NIST 2.1.2.5).
  double rotary_length() const;

  /// Point at the part 0..1 of a line's length, of an arc's angle.
  Axes at(double part) const;

  /// Bounding box. Of an arc whose radii at start and end differ, the spiral's points at k·90° stand for its extremes.
  Extents extents() const;

  /// Number of equal pieces whose chords stay within `chord` mm of the arc; 1 for a line.
  int pieces(double chord) const;

 private:
  double linear_squares(bool outside_plane) const;
  void set_in_plane(Axes& point, Vec2 in_plane) const;

  const AxisRoles& roles_;
  const Axes& from_;
  const Motion& motion_;
  bool arc_ = false;
  std::size_t first_ = 0, second_ = 1;  // axes of the plane
  Vec2 center_;
  Vec2 arm_;              // centre → start
  double sweep_deg_ = 0;  // counter-clockwise positive
  double radius_ = 0;
  double radius_change_ = 0;  // at the end, against the start
};

}  // namespace kadr
