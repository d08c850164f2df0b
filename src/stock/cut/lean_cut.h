#pragma once
// Cuts one sweep of a tilted tool in one brick.

#include "stock/cut/brick_cut.h"
#include "stock/cut/lean_body.h"
#include "stock/cut/lean_way.h"

namespace kadr {

/// A path with a small turn, seen from one brick. In the tool's coordinates, a point of the brick is at
///   middle + sum of axes[d] * place[d] -+ half of (shift + sum of shift_grows[d] * place[d])
/// at the start and at the end of the path; `place` is measured from the brick's middle. mm; x and y from the tool's axis, z above
/// its tip.
struct LeanSweep {
  /// `corner` of the brick, in the path's coordinates; `edge` of the brick.
  LeanSweep(const LeanWay& way, Vec3 corner, double edge);

  float middle[3], shift[3];
  float axes[3][3], shift_grows[3][3];
  float axes_first[3][3], axes_last[3][3];  // at the start and at the end of the path
  float tips[2][3], directions[2][3];       // of the tool at the start and the end, from the brick's middle
  float half_turn;                          // radians
  float aside[3];                           // offset of the brick's middle from its chord, half way
  float bend;                               // upper bound of such an offset for all points of the brick
  float reach;                              // from the brick's middle to its corners
  /// Greatest error in the brick, mm, of a sweep computed for a guessed position.
  float guess_error() const { return half_turn * reach; }
};

/// A set of a brick's lines, one bit each.
struct LineSet {
  static constexpr int at_once = 8;
  std::uint8_t bits[3][brick_lines / at_once] = {};  // by family, then one byte for eight consecutive lines
  bool any = false;
};

/// A sweep of a body.
struct LeanCut {
  const LeanSweep& sweep;
  const LeanBody& body;
  const LocalSweep& tip;          // the path of the tip
  const SweptBody& upright_body;  // the same body
  const LineSet* only = nullptr;  // cuts only these lines; nullptr: all
};

/// True if the body may reach a brick whose material ends at `top` above its lower side. Tests the material's box against the planes
/// of faces, side and ball.
bool may_reach(const LeanSweep& sweep, const LeanBody& body, const BrickScale& scale, float top);

/// Removes what the body sweeps, except from lines that it turns over (lean_over.h).
///   returns  those lines, which are to be cut by the halves of the path
LineSet cut_brick_leaning(Brick& brick, const BrickScale& scale, const LeanCut& cut, std::int32_t by, CutOutcome& outcome,
                          LaneWidth width = widest_lanes());

}  // namespace kadr
