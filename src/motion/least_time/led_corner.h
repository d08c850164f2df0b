#pragma once
// LedCorner: how far a corner of the axes' path may be rounded while the tip is led (tool centre point control, nct 25.14). The axes'
// path has a corner there for two reasons: the tip's own path, and the rotary axes, for which the linear ones compensate. The second has
// no effect on the tip as long as all axes are rounded together. What counts, therefore, is how rounding moves the tip across its path,
// and how it changes the tool's direction at each position of the tip.

#include "action/axis_roles.h"
#include "base/vec.h"

namespace kadr {

/// A straight piece of the axes' path.
struct LedPiece {
  bool known = false;
  double length = 0;  // of the axes' path, mm and degrees
  Axes along{};       // direction of that path, a unit vector
  Vec3 tip;           // the tip's movement in this piece, mm per mm of the axes' path
  double feed = 0;    // mm/s along the axes' path
  /// True if the tip is equally fast in both pieces, whatever the axes do.
  bool keeps_pace(const LedPiece& before) const;
};

/// Returns the piece of the axes' path between two positions, during which the tip goes from `tip_from` to `tip_to`.
LedPiece led_piece(std::size_t axes, const Axes& from, const Axes& to, Vec3 tip_from, Vec3 tip_to, double feed);

/// Returns how far the axes may leave the corner between two pieces so that the tip leaves its own path by at most `tolerance`, mm, and
/// the tool its direction by at most 0.01°. To first order, and bounded where the second order could count.
double led_tolerance(const LedPiece& before, const LedPiece& behind, double tolerance, AxisMask rotary);

}  // namespace kadr
