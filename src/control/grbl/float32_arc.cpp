// Computes Grbl's arcs in 32-bit arithmetic. Used by control/grbl/arc_readings. Tested by tests/grbl_arcs.py, which makes the same
// computation in Python, and by dev/grbl_oracle, which compares with Grbl's own source.

#include "control/grbl/float32_arc.h"

#include <cmath>
#include <numbers>

namespace kadr::grbl {
namespace {

// swept angle in rad up to which Grbl adds a whole revolution; ARC_ANGULAR_TRAVEL_EPSILON of Grbl's source
constexpr float travel_epsilon = 5e-7F;
constexpr float whole_turn = 2 * std::numbers::pi_v<float>;
// Grbl reports no error if the radii at start and end differ by at most error_least (mm); above error_most (mm) it always does so; in
// between if the difference exceeds the fraction error_of_radius of the radius (spec/grbl 5.2).
constexpr float error_least = 0.005F, error_most = 0.5F, error_of_radius = 0.001F;

float length_of(float x, float y) { return std::sqrt(x * x + y * y); }

/// Returns the angle of a vector in rad. The arc tangent is computed as a double and then converted to a float, so that the result is the
/// same with every library.
float angle_of(float y, float x) { return static_cast<float>(std::atan2(double{y}, double{x})); }

/// Returns the number of straight segments into which Grbl divides the arc. Grbl counts the segments in 16 bits, so the count after 65535
/// is 0.
int segments_of(float angle, float radius, float tolerance) {
  constexpr float counts = 65536;
  const float chord = std::sqrt(tolerance * (2 * radius - tolerance));
  const float count = std::floor(std::fabs(0.5F * angle * radius) / chord);
  return std::isfinite(count) ? static_cast<int>(std::fmod(count, counts)) : 0;
}

/// Computes the swept angle and the number of segments of an arc, as mc_arc of Grbl's source does.
Float32Arc led(Float32Pair from, Float32Pair to, Float32Pair offset, float radius, Turn turn, float tolerance) {
  const Float32Pair center{from[0] + offset[0], from[1] + offset[1]};
  const Float32Pair first{-offset[0], -offset[1]}, last{to[0] - center[0], to[1] - center[1]};
  float angle = angle_of(first[0] * last[1] - first[1] * last[0], first[0] * last[0] + first[1] * last[1]);
  if (turn == Turn::cw && angle >= -travel_epsilon) angle -= whole_turn;
  if (turn == Turn::ccw && angle <= travel_epsilon) angle += whole_turn;
  Float32Arc arc;
  arc.offset = {double{center[0]} - double{from[0]}, double{center[1]} - double{from[1]}};
  arc.radius = radius;
  arc.turns = double{std::fabs(angle)} / double{whole_turn};
  arc.segments = segments_of(angle, radius, tolerance);
  return arc;
}

}  // namespace

Float32Arc float32_arc_by_center(Float32Pair from, Float32Pair to, Float32Pair offset, Turn turn, float tolerance) {
  const float radius = length_of(offset[0], offset[1]);
  const float end_radius = length_of(to[0] - from[0] - offset[0], to[1] - from[1] - offset[1]);
  const float error = std::fabs(end_radius - radius);
  if (error > error_least && (error > error_most || error > error_of_radius * radius)) {
    Float32Arc arc;
    arc.answer = Float32Arc::Answer::radius_wrong;
    arc.radius = radius;
    arc.other = end_radius;
    return arc;
  }
  return led(from, to, offset, radius, turn, tolerance);
}

Float32Arc float32_arc_by_radius(Float32Pair from, Float32Pair to, float radius, Turn turn, float tolerance) {
  const float x = to[0] - from[0], y = to[1] - from[1];
  const float four_height_sq = 4 * radius * radius - x * x - y * y;
  if (four_height_sq < 0) {
    Float32Arc arc;
    arc.answer = Float32Arc::Answer::radius_small;
    arc.radius = std::fabs(radius);
    arc.other = length_of(x, y) / 2;
    return arc;
  }
  float height =
      -std::sqrt(four_height_sq) / length_of(x, y);  // twice the distance of the centre from the chord, divided by the chord length
  if (turn == Turn::ccw) height = -height;
  if (radius < 0) height = -height;
  return led(from, to, {0.5F * (x - y * height), 0.5F * (y + x * height)}, std::fabs(radius), turn, tolerance);
}

}  // namespace kadr::grbl
