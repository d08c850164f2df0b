#pragma once
// Computes an arc as Grbl does: each step is rounded to 32 bits, as in the C of an AVR, whose double is a float (spec/grbl 5.2 to 5.4;
// gcode.c, mc_arc). The rounding shows in three cases:
//
//   R far from machine zero: 4R² − x² − y² is a difference of rounded squares, and the centre depends on its root
//   a short part of a large circle: its angle is computed as less than 5e-7 rad, and a whole revolution is added
//   a full circle: its angle is computed as more than 5e-7 rad on the wrong side, and nothing is added

#include <array>
#include <cstdint>

#include "base/vec.h"
#include "control/block/arc.h"

namespace kadr::grbl {

/// A point of the plane in machine coordinates, mm.
using Single2 = std::array<float, 2>;

struct SingleArc {
  enum class Answer : std::uint8_t { moves, radius_small, radius_wrong };  // error:34, error:33
  Answer answer = Answer::moves;
  Vec2 offset;       // from the start to the rounded centre, mm
  double turns = 0;  // swept angle / 360, positive
  int segments = 0;  // 0: straight to the end point
  float radius = 0;  // mm, the radius used to count segments
  float other = 0;   // mm: radius at the end; half of the chord if R is too small
};

/// The arc given by I, J, K. `tolerance`: $12, mm.
SingleArc single_arc_by_center(Single2 from, Single2 to, Single2 offset, Turn turn, float tolerance);

/// The arc given by R; if R is negative, the longer of the two.
SingleArc single_arc_by_radius(Single2 from, Single2 to, float radius, Turn turn, float tolerance);

}  // namespace kadr::grbl
