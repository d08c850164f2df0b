#pragma once
// LedCorner: how far a corner of the axes' path may be rounded where the tip is led (nct 25.14). The axes' path has a corner there by the
// tip's own way, and by the rotary axes, which the linear ones make up for: of the second the tip feels nothing as long as all are rounded
// together. So what counts is what the rounding does to the tip, across its way, and to the direction of the tool at its place on it.

#include "action/axis_roles.h"
#include "base/vec.h"

namespace kadr {

/// A straight piece of the axes' path.
struct LedPiece {
  bool known = false;
  double length = 0;  // of the axes' way, mm and degrees
  Axes along{};       // that way, of length 1
  Vec3 tip;           // the way of the tip in the part, mm a mm of the axes' way
  double feed = 0;    // mm/s of the axes' way
  /// The tip goes equally fast in both, whatever the axes do.
  bool keeps_pace(const LedPiece& before) const;
};

/// Of the axes' way between two places, where the tip goes from one place to another.
LedPiece led_piece(std::size_t axes, const Axes& from, const Axes& to, Vec3 tip_from, Vec3 tip_to, double feed);

/// How far the axes may leave the corner between two pieces so that the tip leaves its own way by no more than `tolerance`, mm, and the
/// tool its direction by no more than 0.01°: to first order, bounded where the second could count.
double led_tolerance(const LedPiece& before, const LedPiece& behind, double tolerance, AxisMask rotary);

}  // namespace kadr
