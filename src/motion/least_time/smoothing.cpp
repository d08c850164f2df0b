// Smoothing joins straight motions under G5.1 into one curve before they are planned. Used by motion/least_time/axis_motion; tested by
// tests/motion/smoothing_test.cpp.

#include "motion/least_time/smoothing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/arithmetic.h"
#include "base/tolerance.h"
#include "config/setup/setup_parameters.h"

namespace kadr {
namespace {

// The chord error of a curve, mm: the same value as for an arc that is followed exactly (AxisMotion).
constexpr double chord_of_curve = 0.04 * tol::exact_path;

double angle_between(const Axes& before, const Axes& after) {
  double squares = 0;
  for (std::size_t a = 0; a < max_axes; ++a) squares += (after[a] - before[a]) * (after[a] - before[a]);
  return 2 * std::asin(std::min(std::sqrt(squares) / 2, 1.0)) / rad_per_deg;
}

}  // namespace

SmoothingRules smoothing_rules(const Setup& setup, const std::vector<std::string>& axes) {
  const SetupParameters given(setup, axes);
  const auto limit = [&](const char* parameter) {
    const double value = given.of_channel(parameter);
    return value > 0 ? value : infinite;
  };
  SmoothingRules rules{limit("3100"),
                       given.of_channel("3101"),
                       limit("3102"),
                       given.of_channel("3104"),
                       given.of_channel("3105"),
                       given.of_channel("3106"),
                       given.of_channel("3107")};
  rules.always_below = std::min(rules.always_below, 2 * rules.fine);
  if (rules.always_below <= given.of_channel("3103")) rules.always_below = 0;
  return rules;
}

bool Smoothing::is_sharp(const Held& before, const Held& after) const {
  // Angle in degrees. Two pieces whose directions differ by more than this angle have no mean direction, so they are not smoothed.
  constexpr double turns_back = 179.9;
  const double angle = angle_between(before.direction, after.direction);
  const bool fine = before.piece.mode == 3 && after.piece.mode == 3;
  const bool short_one = fine && std::min(before.length, after.length) < rules_.always_below;
  return angle > turns_back || (angle > rules_.angle && !short_one);
}

void Smoothing::take(const Piece& piece, const Line& line) {
  Held next{piece, {}, 0, false, false, false, {}};
  for (std::size_t a = 0; a < max_axes; ++a) next.direction[a] = piece.to[a] - piece.from[a];
  for (const double part : next.direction) next.length += part * part;
  next.length = std::sqrt(next.length);
  if (!(next.length > 0)) return;
  for (double& part : next.direction) part /= next.length;
  const double most = piece.mode == 3 ? rules_.fine : rules_.most;
  next.fits = most > 0 && next.length <= rules_.longest && next.length >= rules_.shortest;
  if (held_) {
    next.sharp = is_sharp(*held_, next);
    let_out(&next, line);
    next.curved = before_smoothed_ && next.fits && !next.sharp;
    if (next.curved) next.start = direction_between(held_->direction, held_->length, next.direction, next.length);
  } else {
    before_smoothed_ = false;
  }
  held_ = next;
}

void Smoothing::finish(const Line& line) {
  if (held_) let_out(nullptr, line);
  held_.reset();
}

/// Emits the stored piece. `next` is the piece that follows. If `next` is nullptr, no smoothed piece follows and the stored piece ends in
/// its own direction. NCT 4.7: next to a piece that is not smoothed, the tangent of the curve is the direction of the chord.
void Smoothing::let_out(const Held* next, const Line& line) {
  const Held& held = *held_;
  const Piece& piece = held.piece;
  const bool smooth = held.fits && !held.sharp && !(next != nullptr && next->sharp);
  const bool begins_smooth = smooth && held.curved;
  if (!smooth || piece.mode == 3) {
    line(piece.to, piece.feed, begins_smooth ? rules_.fine : piece.tolerance, false, piece.tag);
    before_smoothed_ = smooth;
    return;
  }
  const bool ends_smooth = next != nullptr && next->fits && next->piece.mode == piece.mode;
  const Bezier curve(piece.from, piece.to, begins_smooth ? held.start : held.direction,
                     ends_smooth ? direction_between(held.direction, held.length, next->direction, next->length) : held.direction);
  const double off = curve.off_chord();
  before_smoothed_ = off <= rules_.most && off >= rules_.least;
  if (!before_smoothed_) return line(piece.to, piece.feed, piece.tolerance, false, piece.tag);
  const int pieces = curve.pieces(chord_of_curve);
  for (int i = 1; i <= pieces; ++i) {
    const bool joins = i > 1 || begins_smooth;
    line(curve.at(static_cast<double>(i) / pieces), piece.feed, joins ? tol::exact_path : piece.tolerance, joins, piece.tag);
  }
}

}  // namespace kadr
