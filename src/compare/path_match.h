#pragma once
// Follows two paths in parallel as long as both stay near each other in order. The distance is the continuous Fréchet distance (Alt, Godau
// 1995, "Computing the Fréchet distance between two polygonal curves"). The free-space diagram is computed from left to right, and only its
// reachable part is in memory.

#include "compare/course_cursor.h"

namespace kadr {

struct PathMatch {
  // True if the paths stayed together until one of them ended or its state changed; false if they separate at the present positions of the
  // cursors.
  bool together = true;
  double reach = 0;     // greatest distance of a point of either path from the start of its path, mm
  double greatest = 0;  // greatest distance between the paths that no matching can avoid, measured at the vertices of both, mm
};

/// Follows both courses from their current positions, which are at most `tolerance` (mm) apart. Stops where the state changes within a
/// course. Where one path ends, the segment of the other path is cut in two at the nearest position.
///   pre  the first item of each course is a motion
PathMatch match_paths(CourseCursor& a, CourseCursor& b, const CourseSpace& space, double tolerance);

}  // namespace kadr
