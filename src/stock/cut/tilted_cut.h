#pragma once
// Removes from one brick the material that a tilted tool sweeps.

#include "stock/cut/brick_cut.h"
#include "stock/cut/tilted_body.h"
#include "stock/cut/tilted_path.h"

namespace kadr {

/// A path on which the tool turns only a little, as seen from one brick. `place` is the vector from the brick's middle to a point of the
/// brick. The position of this point in the tool's coordinates (x, y from the tool's axis, z above the tip, mm) at the start of the path is
///   middle + sum of axes[d] * place[d] - half of (shift + sum of shift_grows[d] * place[d])
/// The position at the end of the path is the same sum with + instead of -.
struct TiltedSweep {
  ///   corner  position of the brick's corner, in the coordinates of `path`
  ///   edge    edge length of the brick, mm
  TiltedSweep(const TiltedPath& path, Vec3 corner, double edge);

  float middle[3], shift[3];
  float axes[3][3], shift_grows[3][3];
  float axes_first[3][3], axes_last[3][3];  // axes of the tool at the start and at the end of the path
  // Tip (mm) and direction of the tool at the start and the end of the path, relative to the brick's middle.
  float tips[2][3], directions[2][3];
  float half_turn;  // half the angle by which the tool turns on the path, radians
  // The middle of the brick moves past the tool on a curve. `aside` is the vector in mm from the chord of this curve to the curve, half way
  // along the path.
  float aside[3];
  float bend;   // greatest distance in mm between the path of a point of the brick past the tool and the chord of this path (upper bound)
  float reach;  // distance from the brick's middle to the brick's corners, mm
  /// Returns an upper bound, in mm, of the error of an intersection with a lattice line that is computed with an estimated shift. The shift
  /// of a point past the tool depends on the point, so the shift at an estimated position differs a little from the shift at the true
  /// position.
  float guess_error() const { return half_turn * reach; }
};

/// A set of lattice lines of a brick, one bit for each line.
struct LineSet {
  static constexpr int at_once = 8;
  std::uint8_t bits[3][brick_lines / at_once] = {};  // bits by family; each byte holds the bits of eight consecutive lines
  bool any = false;
};

/// The body of a tool and the sweep that are to be cut from a brick.
struct TiltedCut {
  const TiltedSweep& sweep;
  const TiltedBody& body;
  const LocalSweep& tip;          // the path of the tool's tip, in the form that upright tools use
  const SweptBody& upright_body;  // the same body as `body`, in the form for an upright tool
  const LineSet* only = nullptr;  // the lines to cut; nullptr: all lines
};

/// Returns true if the body may reach a brick whose material ends at the height `top` mm above the brick's lower side. The function tests
/// the box of the material against planes: the body's flat faces, and planes that touch the side or the ball of the body.
bool may_reach(const TiltedSweep& sweep, const TiltedBody& body, const BrickScale& scale, float top);

/// Removes the material that the body sweeps. Leaves out lattice lines for which a tool that turns may sweep two separate intervals
/// (tilted_over.h).
///   returns  the lines that were left out; the caller must cut them with the two halves of the path instead
LineSet cut_brick_tilted(Brick& brick, const BrickScale& scale, const TiltedCut& cut, std::int32_t by, CutOutcome& outcome,
                         LaneWidth width = widest_lanes());

}  // namespace kadr
