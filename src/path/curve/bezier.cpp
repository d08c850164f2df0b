// Bezier is a cubic curve between two points of the axes' space with given directions at its ends. Used by motion/least_time/smoothing.

#include "path/curve/bezier.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr int max_bezier_pieces = 1000;

double size(const Axes& vector) {
  double squares = 0;
  for (const double part : vector) squares += part * part;
  return std::sqrt(squares);
}

Axes between(const Axes& from, const Axes& to) {
  Axes delta{};
  for (std::size_t a = 0; a < max_axes; ++a) delta[a] = to[a] - from[a];
  return delta;
}

Axes times(const Axes& vector, double factor) {
  Axes all = vector;
  for (double& part : all) part *= factor;
  return all;
}

}  // namespace

Axes direction_between(const Axes& before, double before_length, const Axes& after, double after_length) {
  Axes direction{};
  for (std::size_t a = 0; a < max_axes; ++a) direction[a] = after_length * before[a] + before_length * after[a];
  return times(direction, 1 / size(direction));
}

Bezier::Bezier(const Axes& from, const Axes& to, const Axes& start_direction, const Axes& end_direction) : from_(from), to_(to) {
  const double third = size(between(from, to)) / 3;
  start_pull_ = times(start_direction, third);
  end_pull_ = times(end_direction, third);
}

Axes Bezier::at(double part) const {
  if (part <= 0) return from_;
  if (part >= 1) return to_;
  const double rest = 1 - part;
  const double first = 3 * rest * rest * part, second = 3 * rest * part * part, third = part * part * part;
  Axes point{};
  for (std::size_t a = 0; a < max_axes; ++a)
    point[a] = from_[a] + first * start_pull_[a] + second * (to_[a] - from_[a] - end_pull_[a]) + third * (to_[a] - from_[a]);
  return point;
}

/// The curve is sampled so densely that its maximum distance from the chord is found to within 0.1 %.
double Bezier::off_chord() const {
  constexpr int places = 64;
  const Axes chord = between(from_, to_);
  const double length = size(chord);
  double most = 0;
  for (int i = 1; i < places; ++i) {
    const Axes away = between(from_, at(static_cast<double>(i) / places));
    double along = 0, squares = 0;
    for (std::size_t a = 0; a < max_axes; ++a) along += away[a] * chord[a], squares += away[a] * away[a];
    along /= length;
    most = std::max(most, squares - along * along);
  }
  return std::sqrt(most);
}

/// The greatest distance between a curve and its chord is at most h²/8 · |x″| if the chord spans the fraction h of the parameter range.
/// Here x″ is the second derivative with respect to the parameter; |x″| is greatest at an end of the curve.
int Bezier::pieces(double chord) const {
  Axes start{}, end{};
  for (std::size_t a = 0; a < max_axes; ++a) {
    const double travel = to_[a] - from_[a];
    start[a] = 6 * (travel - end_pull_[a] - 2 * start_pull_[a]);
    end[a] = 6 * (2 * end_pull_[a] + start_pull_[a] - travel);
  }
  const double count = std::ceil(std::sqrt(std::max(size(start), size(end)) / (8 * chord)));
  return static_cast<int>(std::clamp(count, 1.0, double{max_bezier_pieces}));
}

}  // namespace kadr
