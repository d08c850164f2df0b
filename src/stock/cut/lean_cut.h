#pragma once
// One sweep of a tool that leans in one brick.

#include "stock/cut/brick_cut.h"
#include "stock/cut/lean_body.h"
#include "stock/cut/lean_way.h"

namespace kadr {

/// A way that turns little, seen from one brick. A place of the brick lies, seen from the tool, at
///   middle + sum of axes[d] * place[d] -+ half of (shift + sum of shift_grows[d] * place[d])
/// at the beginning and at the end of the way; place: from the brick's middle. mm, x and y beside the tool's axis, z above its tip.
struct LeanSweep {
  /// `corner`: of the brick, in the way's coordinates; `edge`: of it.
  LeanSweep(const LeanWay& way, Vec3 corner, double edge);

  float middle[3], shift[3];
  float axes[3][3], shift_grows[3][3];
  float axes_first[3][3], axes_last[3][3];  // as they are at the beginning and the end
  float tips[2][3], directions[2][3];       // of the tool at the beginning and the end, from the brick's middle
  float half_turn;                          // radians
  float aside[3];                           // halfway, of the brick's middle from its chord
  float bend;                               // the most of it that a place of the brick has
  float reach;                              // from the brick's middle to its corners
  /// By which the sweep of a guessed place may be wrong anywhere in the brick, mm.
  float guess_error() const { return half_turn * reach; }
};

/// Lines of a brick, a bit each.
struct LineSet {
  static constexpr int at_once = 8;
  std::uint8_t bits[3][brick_lines / at_once] = {};  // by family, then eight lines each from a multiple of it on
  bool any = false;
};

/// A sweep of a body.
struct LeanCut {
  const LeanSweep& sweep;
  const LeanBody& body;
  const LocalSweep& tip;          // the way of the tip
  const SweptBody& upright_body;  // the same body
  const LineSet* only = nullptr;  // these lines; null: all
};

/// Whether the body may reach a brick whose material ends at `top` above its lower side: as a box, by the planes of faces, side and ball.
bool may_reach(const LeanSweep& sweep, const LeanBody& body, const BrickScale& scale, float top);

/// Takes away what the body sweeps, but of lines that it turns over (lean_over.h).
///   returns  these lines: they are to be cut by the halves of the way
LineSet cut_brick_leaning(Brick& brick, const BrickScale& scale, const LeanCut& cut, std::int32_t by, CutOutcome& outcome,
                          LaneWidth width = widest_lanes());

}  // namespace kadr
