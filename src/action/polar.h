#pragma once
// PolarPath: a path programmed in a flat plane, carried out by a linear and a rotary axis. NCT 4.5:
//   linear = side · sqrt(u² + w² − p²),   rotary = atan2(side·w, side·u) − atan2(p, linear), continuous from its start.

#include "action/flat_path.h"

namespace kadr {

/// Of the two axes: mm and degrees, or mm and degrees per part.
struct PolarAxes {
  double linear = 0;
  double rotary = 0;
};

/// A view of a path; it must outlive this.
class PolarPath {
 public:
  /// `side`: sign of the linear axis; `offset`: p, mm; `rotary_start`: the rotary axis at part 0, degrees.
  PolarPath(const FlatPath& path, double side, double offset, double rotary_start)
      : path_(path), side_(side), offset_(offset), rotary_start_(rotary_start) {}

  PolarAxes at(double part) const;

  /// How fast the axes move: d at(part) / d part. In the rotation centre itself the rotary axis has no speed.
  PolarAxes rates(double part) const;

  /// Distance of the rotation centre from the tool, mm.
  double distance(double part) const { return length(path_.at(part)); }

  /// The part at which the tool is nearest to the rotation centre (exact for a line; by search for an arc).
  double nearest() const;

  /// Least and most of both axes.
  void extremes(PolarAxes& least, PolarAxes& most) const;

  /// Number of equal pieces whose chords keep the linear axis within `chord` mm.
  int pieces(double chord) const;

 private:
  double linear_at(Vec2 point) const;
  double skew_deg(Vec2 point) const;

  const FlatPath& path_;
  double side_;
  double offset_;
  double rotary_start_;
};

}  // namespace kadr
