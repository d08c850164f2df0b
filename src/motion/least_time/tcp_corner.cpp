// This file computes the tolerance of corners of the axes' path under tool centre point control. Used by motion/least_time/axis_motion;
// tested by tests/motion/tcp_corner_test.cpp.

#include "motion/least_time/tcp_corner.h"

#include <algorithm>
#include <cmath>

#include "base/matrix.h"

namespace kadr {
namespace {

// The change of direction |Δu| below which two pieces count as collinear. The value allows for rounding errors.
constexpr double straight_on = 1e-12;
// The greatest deviation of the axes at a rounded corner, mm. It applies even if the tip would stay within its tolerance at a greater
// deviation. If the tolerance is larger than this value, the tolerance applies instead.
constexpr double most_off = 0.1;
constexpr double max_swing = 0.05;  // greatest deviation of a rotary axis at a rounded corner, degrees
// The allowed error of the tool direction, degrees. It is half of the error that the test of the five-axis samples allows
// (docs/planner.md).
constexpr double of_direction = 0.01;

/// Returns the rotation per travel of the tip, degrees/mm, or 0 if the tip does not move.
double rate(double degrees, Vec3 tip) {
  constexpr double stands = 1e-9;
  const double travel = length(tip);
  return travel > stands ? degrees / travel : 0;
}

}  // namespace

TcpPiece tcp_piece(std::size_t axes, const Axes& from, const Axes& to, Vec3 tip_from, Vec3 tip_to, double feed) {
  TcpPiece piece;
  piece.feed = feed;
  double squares = 0;
  for (std::size_t a = 0; a < axes; ++a) squares += (to[a] - from[a]) * (to[a] - from[a]);
  piece.length = std::sqrt(squares);
  if (!(piece.length > 0)) return piece;
  piece.known = true;
  for (std::size_t a = 0; a < axes; ++a) piece.along[a] = (to[a] - from[a]) / piece.length;
  piece.tip = 1 / piece.length * (tip_to - tip_from);
  return piece;
}

bool TcpPiece::keeps_pace(const TcpPiece& before) const {
  constexpr double same = 1e-3;  // greatest relative difference of the tip speeds in two chords of the same curve
  const double now = feed * kadr::length(tip), then = before.feed * kadr::length(before.tip);
  return known && before.known && now > 0 && std::fabs(now - then) <= same * now;
}

double tcp_tolerance(const TcpPiece& before, const TcpPiece& after, double tolerance, AxisMask rotary) {
  double turn = 0, swing = 0, off_direction = 0;
  const Vec3 bend = after.tip - before.tip, on = unit(unit(before.tip) + unit(after.tip));
  const double along = dot(bend, on), off = length(bend - along * on);
  for (std::size_t a = 0; a < max_axes; ++a) {
    const double change = after.along[a] - before.along[a];
    turn += change * change;
    if ((rotary >> a & 1U) == 0) continue;
    swing += change * change;
    const double one = rate(before.along[a], before.tip), other = rate(after.along[a], after.tip);
    // The part of the change of the axis' rotation rate that is not caused by a change of the speed of the tool tip. This part changes the
    // tool direction at a given tip position.
    const double across = change - (one + other) / 2 * along;
    off_direction += across * across;
  }
  turn = std::sqrt(turn);
  if (turn < straight_on) return tolerance;
  // The greatest deviation of the tip or of the tool direction, as a fraction of the allowed deviation, per unit by which the axes deviate
  // from their corner.
  const double felt = std::max(off / tolerance, std::sqrt(off_direction) / of_direction);
  return std::min(
      {turn / std::max(felt, straight_on), std::max(most_off, tolerance), max_swing * turn / std::max(std::sqrt(swing), straight_on)});
}

}  // namespace kadr
