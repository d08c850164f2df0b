#pragma once
// Follows two paths in parallel as long as both stay near each other in order. The measure is the continuous Fréchet distance (Alt, Godau
// 1995, "Computing the Fréchet distance between two polygonal curves"). It is computed from left to right; only the reachable part of the
// free-space diagram is in memory.

#include "compare/course_cursor.h"

namespace kadr {

struct PathMatch {
  bool together = true;  // true: followed until one path ends or its state changes; false: the paths separate where the lanes are now
  double reach = 0;      // mm, the greatest distance of either path from its start
  double greatest = 0;   // mm, the greatest distance between the paths that no matching can avoid, at the vertices of both
};

/// Follows both lanes from their current positions, which are at most `tolerance` apart, along motions whose state does not change within
/// a lane. Where one path ends, the other is cut in two at the nearest position.
///   pre  the first item of both lanes is a motion
PathMatch match_paths(CourseCursor& a, CourseCursor& b, const CourseSpace& space, double tolerance);

}  // namespace kadr
