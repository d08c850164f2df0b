#pragma once
// Stretch: two ways gone along side by side, as far as both stay near each other in their order: the continuous Fréchet distance (Alt,
// Godau 1995, "Computing the Fréchet distance between two polygonal curves"), carried out from left to right with only so much of the free
// space in memory as can be reached.

#include "compare/lane.h"

namespace kadr {

struct StretchResult {
  bool together = true;  // to where one of them ends or changes what is in force; false: they part where the lanes stand now
  double reach = 0;      // mm, how far either came from where it began on the way
  double greatest = 0;   // mm, of those distances that cannot be less, over the vertices of both
};

/// From where both lanes stand, at most `tolerance` apart, along moves with what is in force on each. Where one comes to its end the other
/// is cut in two at the nearest place.
///   pre  both have a move first
StretchResult go_along(Lane& a, Lane& b, const CourseSpace& space, double tolerance);

}  // namespace kadr
