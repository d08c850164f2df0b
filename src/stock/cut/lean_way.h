#pragma once
// LeanWay: the path of a tilted tool. The tip moves evenly along a straight path, and the direction evenly along the shortest turn.
//
// A point of the material, in the tool's coordinates, moves along a curve that is nearly straight. If the curve is replaced by its
// chord, the tool sweeps the point as if it only shifted. The shift is taken at each point separately, so that both ends of a part of
// the path are exact up to rounding. The remaining error is the distance of the curve from its chord:
//
//   bend = way · turn / 4 + reach · turn² / 8      turn: of the part, radians; reach: of the tool from its tip, mm

#include <array>

#include "base/matrix.h"
#include "base/vec.h"
#include "stock/cut/local_sweep.h"
#include "stock/tool/round_solid.h"

namespace kadr {

struct LeanWay {
  Vec3 from, to;                      // of the tip
  Vec3 from_direction, to_direction;  // from the tip into the tool, unit length

  Vec3 tip(double part) const { return from + part * (to - from); }
  Vec3 direction(double part) const;
  double turn() const;  // radians
  LeanWay between(double first, double last) const { return {tip(first), tip(last), direction(first), direction(last)}; }
};

/// Greatest turn of a part, radians: the final position on a line is found from a guessed one.
inline constexpr double most_turn = 0.02;

/// Returns the number of parts of a path, such that none bends by more than `bend`, mm.
///   reach  from the tip to the farthest point of the tool, mm
int parts_of(const LeanWay& way, double reach, double bend);

double reach_of(const ToolShape& tool);

/// True if the direction is vertical up to rounding.
inline bool is_upright(Vec3 direction) { return std::fabs(direction.x) < 1e-9 && std::fabs(direction.y) < 1e-9 && direction.z > 0; }

/// The tool's own axes in one pose: rows x and y across it, z along it.
using ToolAxes = std::array<Vec3, 3>;

/// Converts a point into the tool's coordinates at the start, half way and at the end of a path; x, y from its axis, z above its tip.
struct ToolEnds {
  explicit ToolEnds(const LeanWay& way);
  Vec3 first(Vec3 place) const { return in(axes_first, place - from); }
  Vec3 last(Vec3 place) const { return in(axes_last, place - to); }
  Vec3 halfway(Vec3 place) const { return in(axes_halfway, place - 0.5 * (from + to)); }
  static Vec3 in(const ToolAxes& axes, Vec3 v) { return {dot(axes[0], v), dot(axes[1], v), dot(axes[2], v)}; }

  Vec3 from, to;
  ToolAxes axes_first, axes_halfway, axes_last;
};

/// Returns a box around a body of a tool on a path with a small turn.
///   low, high  heights of the body above the tip
Box3 box_around(const LeanWay& way, double low, double high, double radius);

/// Upper bound of the room that a body needs around its tip on the path, whatever directions it takes in between.
AroundTip around_leaning_tip(const LeanWay& way, double low, double high, double radius);

}  // namespace kadr
