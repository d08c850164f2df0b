#pragma once
// Computes an arc as Grbl does. The result of each operation is rounded to 32 bits, because a double is a float for the C compiler of the
// AVR processor (spec/grbl 5.2 to 5.4; gcode.c, mc_arc). The numerical rounding has visible effects in three cases:
//
//   an arc with R far from machine zero: with the chord (x, y), the centre depends on the square root of 4R² − x² − y², which is a
//     difference of rounded squares
//   a short arc of a large circle: its angle is computed as less than 5e-7 rad, so Grbl adds a whole revolution
//   a full circle: its angle is computed as more than 5e-7 rad in the arc's direction, so Grbl adds no revolution and hardly moves

#include <array>
#include <cstdint>

#include "base/vec.h"
#include "control/block/arc.h"

namespace kadr::grbl {

/// A point in the active plane, machine coordinates in mm.
using Float32Pair = std::array<float, 2>;

struct Float32Arc {
  // Grbl's result for the arc: radius_wrong is its error:33, radius_small its error:34.
  enum class Answer : std::uint8_t { moves, radius_small, radius_wrong };
  Answer answer = Answer::moves;
  Vec2 offset;       // vector from the start to the centre in mm, as 32-bit values
  double turns = 0;  // swept angle in revolutions, positive
  int segments = 0;  // number of straight segments; 0: one straight motion to the end point
  float radius = 0;  // radius in mm that determines the number of segments
  // second length in mm that the text of the alarm shows: radius at the end (radius_wrong), or half the chord (radius_small)
  float other = 0;
};

/// Computes the arc whose centre the words I, J, K give. `tolerance`: setting $12 (arc tolerance), mm.
Float32Arc float32_arc_by_center(Float32Pair from, Float32Pair to, Float32Pair offset, Turn turn, float tolerance);

/// Computes the arc whose radius the word R gives. If R is negative, the result is the longer of the two possible arcs. `tolerance`:
/// setting $12 (arc tolerance), mm.
Float32Arc float32_arc_by_radius(Float32Pair from, Float32Pair to, float radius, Turn turn, float tolerance);

}  // namespace kadr::grbl
