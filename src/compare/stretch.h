#pragma once
// Follows two paths side by side as far as both stay near each other in order: the continuous Fréchet distance (Alt, Godau 1995, "Computing
// the Fréchet distance between two polygonal curves"), computed from left to right with only the reachable part of the free space in
// memory.

#include "compare/lane.h"

namespace kadr {

struct StretchResult {
  bool together = true;  // true: to where one of them ends or its state changes; false: they part where the lanes are now
  double reach = 0;      // mm, the greatest distance of either from where it began
  double greatest = 0;   // mm, the greatest of the distances that no matching can avoid, over the vertices of both
};

/// Follows both lanes from where they are, at most `tolerance` apart, along moves with the same state on each. Where one ends, the other is
/// cut in two at the nearest position.
///   pre  the first item of both is a move
StretchResult go_along(Lane& a, Lane& b, const CourseSpace& space, double tolerance);

}  // namespace kadr
