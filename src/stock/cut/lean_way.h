#pragma once
// LeanWay: how a tool that leans goes: the tip along a straight way, its direction from one to another along the shortest turn, both
// evenly.
//
// A place of the material, seen from the tool, moves along a curve that is nearly straight. Taken for straight, the tool sweeps it as if it
// only shifted: the shift is that of the tool's own matter at the place, so that it is right at every place alike, and the two ends of a
// part of the way are right but for rounding. What is left is how far the curve bends away from its chord:
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
  Vec3 from_direction, to_direction;  // from the tip into the tool, of length 1

  Vec3 tip(double part) const { return from + part * (to - from); }
  Vec3 direction(double part) const;
  double turn() const;  // radians
  LeanWay between(double first, double last) const { return {tip(first), tip(last), direction(first), direction(last)}; }
};

/// At most this is a part turned by, radians: what is found on a line in the end comes from a place on it that was guessed.
inline constexpr double most_turn = 0.02;

/// Parts in which a way is taken so that none bends by more than `bend`.
///   reach  from the tip to the farthest place of the tool, mm
int parts_of(const LeanWay& way, double reach, double bend);

double reach_of(const ToolShape& tool);

/// Upright, but for rounding.
inline bool is_upright(Vec3 direction) { return std::fabs(direction.x) < 1e-9 && std::fabs(direction.y) < 1e-9 && direction.z > 0; }

/// The tool's own axes where it stands: rows x, y beside, z along it.
using ToolAxes = std::array<Vec3, 3>;

/// A place's coordinates in the tool as it stands at the beginning, halfway and at the end of a way, x, y beside its axis, z above its tip.
struct ToolEnds {
  explicit ToolEnds(const LeanWay& way);
  Vec3 first(Vec3 place) const { return in(axes_first, place - from); }
  Vec3 last(Vec3 place) const { return in(axes_last, place - to); }
  Vec3 halfway(Vec3 place) const { return in(axes_halfway, place - 0.5 * (from + to)); }
  static Vec3 in(const ToolAxes& axes, Vec3 v) { return {dot(axes[0], v), dot(axes[1], v), dot(axes[2], v)}; }

  Vec3 from, to;
  ToolAxes axes_first, axes_halfway, axes_last;
};

/// Box around a body of a tool on a way that turns little.
///   low, high  heights of the body above the tip
Box3 box_around(const LeanWay& way, double low, double high, double radius);

/// The most that a body needs around its tip on the way, whatever way it turns between.
AroundTip around_leaning_tip(const LeanWay& way, double low, double high, double radius);

}  // namespace kadr
