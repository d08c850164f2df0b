#pragma once
// An arc as Grbl works it out: each step rounded to 32 bits, as the C of an AVR does it, whose double is a float (spec/grbl 5.2 to 5.4;
// gcode.c, mc_arc). Numbers in, numbers out.
//
//   R far from the machine's zero: 4R² − x² − y² is a difference of rounded squares, the centre lies on its root
//   a short part of a large circle: its angle comes out within 5e-7 rad, and a whole turn is added
//   a full circle: it comes out beyond 5e-7 rad on the wrong side, and nothing is added

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
  Vec2 offset;       // of the centre, which is rounded, from the start, mm
  double turns = 0;  // swept angle / 360, positive
  int segments = 0;  // 0: straight to the end point
  float radius = 0;  // mm, as the segments are counted by
  float other = 0;   // mm: radius at the end; half of the chord where R is too small
};

/// By I, J, K. `tolerance`: $12, mm.
SingleArc single_arc_by_center(Single2 from, Single2 to, Single2 offset, Turn turn, float tolerance);

/// By R; negative: the longer of the two.
SingleArc single_arc_by_radius(Single2 from, Single2 to, float radius, Turn turn, float tolerance);

}  // namespace kadr::grbl
