#pragma once
// Removes from one brick the material that a tilted tool sweeps.

#include "stock/cut/brick_cut.h"
#include "stock/cut/tilted_body.h"
#include "stock/cut/tilted_path.h"

namespace kadr {

/// A path on which the tool turns only a little, as seen from one brick. A point of the brick is given by `place`, its vector from the
/// brick's middle. Its position in the tool's coordinates (x, y from the tool's axis, z above the tip, mm) is at the start of the path
///   middle + sum of axes[d] * place[d] - half of (shift + sum of shift_grows[d] * place[d])
/// and at the end the same with + half.
struct TiltedSweep {
  ///   corner  position of the brick's corner, in the coordinates of `way`
  ///   edge    edge length of the brick, mm
  TiltedSweep(const TiltedPath& way, Vec3 corner, double edge);

  float middle[3], shift[3];
  float axes[3][3], shift_grows[3][3];
  float axes_first[3][3], axes_last[3][3];  // tool's axes at the start and at the end of the path
  float tips[2][3], directions[2][3];       // tip and direction of the tool at the start and the end, relative to the brick's middle
  float half_turn;                          // half the angle by which the tool turns, radians
  float aside[3];                           // half way along the path: offset of the brick's middle from the chord of its path
  float bend;                               // upper bound of this offset for all points of the brick
  float reach;                              // distance from the brick's middle to its corners
  /// Greatest error of an intersection in the brick, mm, if the intersection is computed with the shift that belongs to another position on
  /// the line.
  float guess_error() const { return half_turn * reach; }
};

/// A set of lattice lines of a brick, one bit for each line.
struct LineSet {
  static constexpr int at_once = 8;
  std::uint8_t bits[3][brick_lines / at_once] = {};  // indices: family, then one byte for each eight consecutive lines
  bool any = false;
};

/// What is to be cut: one body of the tool in one sweep.
struct TiltedCut {
  const TiltedSweep& sweep;
  const TiltedBody& body;
  const LocalSweep& tip;          // path of the tip alone
  const SweptBody& upright_body;  // the same body as `body`, for the case that the tool is upright
  const LineSet* only = nullptr;  // if not nullptr, only these lines are cut
};

/// Returns true if the body may reach a brick whose material ends at the height `top` above the brick's lower side. Tests the box of
/// the material against planes: the body's faces and tangents to its side or ball.
bool may_reach(const TiltedSweep& sweep, const TiltedBody& body, const BrickScale& scale, float top);

/// Removes what the body sweeps, except from lines over which its surface turns during the sweep (tilted_over.h).
///   returns  the lines left out; the caller must cut them with the two halves of the path instead
LineSet cut_brick_tilted(Brick& brick, const BrickScale& scale, const TiltedCut& cut, std::int32_t by, CutOutcome& outcome,
                         LaneWidth width = widest_lanes());

}  // namespace kadr
