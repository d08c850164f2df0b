#pragma once
// TiltedPath: the path of a tilted tool. The tip moves evenly on a straight line, and the direction of the tool turns evenly along the
// shortest arc.
//
// In the tool's coordinates, a point of the material moves on a nearly straight curve. If the chord of this curve replaces the curve, the
// tool sweeps the point by a shift alone, without a turn. Each point has its own shift, so the poses at both ends of a part of the path are
// exact up to rounding. The remaining error is the greatest distance of the curve from its chord:
//
//   bend = way · turn / 4 + reach · turn² / 8      way: length of the part, mm; turn: angle of the tool's turn in the part, radians;
//                                                  reach: greatest distance of the tool's points from its tip, mm

#include <array>

#include "base/matrix.h"
#include "base/vec.h"
#include "stock/cut/local_sweep.h"
#include "stock/tool/round_solid.h"

namespace kadr {

struct TiltedPath {
  Vec3 from, to;                      // start and end position of the tip, mm
  Vec3 from_direction, to_direction;  // unit vectors from the tip into the tool

  Vec3 tip(double part) const { return from + part * (to - from); }
  Vec3 direction(double part) const;
  double turn() const;  // angle between the directions at the start and the end, radians
  TiltedPath between(double first, double last) const { return {tip(first), tip(last), direction(first), direction(last)}; }
};

/// Greatest turn of a part of a path, radians. A larger turn would make the result inaccurate, because the final position on a line is
/// computed from an estimated position.
inline constexpr double max_turn = 0.02;

/// Returns the number of equal parts into which a path must be divided so that no part bends by more than `bend` mm.
///   reach  distance from the tip to the farthest point of the tool, mm
int parts_of(const TiltedPath& path, double reach, double bend);

double reach_of(const ToolShape& tool);

/// Returns true if the direction is vertical (Z+) to within rounding errors.
inline bool is_upright(Vec3 direction) { return std::fabs(direction.x) < 1e-9 && std::fabs(direction.y) < 1e-9 && direction.z > 0; }

/// The tool's own axes in one pose: the rows x and y are across the tool's axis, the row z is along this axis.
using ToolAxes = std::array<Vec3, 3>;

/// Converts a point into the tool's coordinates at the start, half way and at the end of a path: x, y from the tool's axis, z above the
/// tip.
struct ToolEnds {
  explicit ToolEnds(const TiltedPath& path);
  Vec3 first(Vec3 place) const { return in(axes_first, place - from); }
  Vec3 last(Vec3 place) const { return in(axes_last, place - to); }
  Vec3 halfway(Vec3 place) const { return in(axes_halfway, place - 0.5 * (from + to)); }
  static Vec3 in(const ToolAxes& axes, Vec3 v) { return {dot(axes[0], v), dot(axes[1], v), dot(axes[2], v)}; }

  Vec3 from, to;
  ToolAxes axes_first, axes_halfway, axes_last;
};

/// Returns a box around the volume that a body of a tool sweeps on a path with a small turn.
///   low, high  heights of the bottom and the top of the body above the tip, mm
Box3 box_around(const TiltedPath& path, double low, double high, double radius);

/// Returns upper bounds for the distances by which a body extends around its tip, for all directions of the tool on the path.
AroundTip around_tilted_tip(const TiltedPath& path, double low, double high, double radius);

}  // namespace kadr
