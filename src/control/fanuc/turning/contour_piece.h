#pragma once
// A line or an arc of the contour of a turning cycle, and the division of arcs where an axis reverses. Pure geometry: this file knows
// nothing of programs and machines.

#include <cstdint>
#include <vector>

#include "action/motion.h"
#include "base/vec.h"

namespace kadr::fanuc {

/// A motion of the contour in the plane, in programmed coordinates, mm. It is a line, or an arc whose radius changes linearly with the
/// angle.
struct ContourPiece {
  MotionKind kind = MotionKind::rapid;
  Vec2 from, to;
  Vec2 center;
  double turns = 0;         // swept angle of an arc in revolutions, positive; 0 for a line
  std::uint32_t block = 0;  // block number N of the block that programs this motion

  bool is_arc() const { return kind == MotionKind::arc_cw || kind == MotionKind::arc_ccw; }
  /// Returns the point at a fraction 0 … 1 of the line's length or of the arc's angle.
  Vec2 at(double part) const;
};

/// Splits arcs at the points where one of the axes reverses. Along each line or arc of the result, neither axis reverses its direction.
std::vector<ContourPiece> monotone(const std::vector<ContourPiece>& pieces);

}  // namespace kadr::fanuc
