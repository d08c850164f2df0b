#pragma once
// Closed paths of the tool's centre at a distance from the wall of a pocket or stud. The milling cycles of several controls clear an area
// with them. All coordinates are those of the shape: its centre is the origin, its sides are parallel to the axes.

#include <vector>

#include "base/vec.h"

namespace kadr {

/// A straight move, or an arc about `centre`, from the end of the move before it.
struct RingMove {
  Vec2 to;
  Vec2 centre;
  double turns = 0;  // revolutions of the arc; 0: the move is straight
};

/// A rectangle with rounded corners: half of its length and of its width, and the radius of its corners, mm.
struct RoundedRectangle {
  double half_length = 0, half_width = 0, corner = 0;
  /// Returns the rectangle whose sides are moved inwards by `distance`; outwards if it is negative.
  RoundedRectangle inset(double distance) const;
  bool is_circle() const;
};

/// Appends one round along the rectangle, with a straight move to its first point: the middle of the side towards -Y; of a circle the
/// point towards +X. A rectangle without length and width gives nothing.
void append_ring(std::vector<RingMove>& moves, RoundedRectangle shape, bool clockwise);

/// Appends rings from the middle to `outer`, whose distance is at most `width`, and the way back to the middle.
void append_rings(std::vector<RingMove>& moves, RoundedRectangle outer, double width, bool clockwise);

}  // namespace kadr
