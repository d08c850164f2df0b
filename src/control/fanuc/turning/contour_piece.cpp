// Points of the lines and arcs of a turning contour, and the division of its arcs. Used by control/fanuc/turning and control/fanuc/lathe.

#include "control/fanuc/turning/contour_piece.h"

#include <cmath>

namespace kadr::fanuc {

Vec2 ContourPiece::at(double part) const {
  if (!is_arc()) return from + part * (to - from);
  if (part == 0) return from;
  if (part == 1) return to;
  const double r0 = length(from - center), r1 = length(to - center);
  const double angle = angle_deg(from - center) + (kind == MotionKind::arc_ccw ? 360 : -360) * turns * part;
  const SinCos direction = sincos_deg(angle);
  return center + (r0 + (r1 - r0) * part) * Vec2{direction.cos, direction.sin};
}

std::vector<ContourPiece> monotone(const std::vector<ContourPiece>& pieces) {
  std::vector<ContourPiece> cut;
  for (const ContourPiece& piece : pieces) {
    if (!piece.is_arc()) {
      cut.push_back(piece);
      continue;
    }
    const bool ccw = piece.kind == MotionKind::arc_ccw;
    const double sweep = 360 * piece.turns;
    // angle in degrees of the arc's start point, positive in the arc's direction of rotation
    const double begin = (ccw ? 1 : -1) * angle_deg(piece.from - piece.center);
    double done = 0;
    for (double quarter = 90 * (std::floor(begin / 90) + 1); done < 1; quarter += 90) {
      const double part = quarter - begin < sweep ? (quarter - begin) / sweep : 1;
      ContourPiece section = piece;
      section.from = piece.at(done);
      section.to = piece.at(part);
      section.turns = piece.turns * (part - done);
      cut.push_back(section);
      done = part;
    }
  }
  return cut;
}

}  // namespace kadr::fanuc
