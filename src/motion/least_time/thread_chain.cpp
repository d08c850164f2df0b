// ThreadChain plans consecutive threads as one motion that is synchronised with the spindle. Used by motion/least_time/axis_motion; tested
// by tests/motion/thread_chain_test.cpp.

#include "motion/least_time/thread_chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace kadr {
namespace {

double path_speed(const Axes& speed) {
  double squares = 0;
  for (const double of_axis : speed) squares += of_axis * of_axis;
  return squares > 0 ? std::sqrt(squares) : 1;
}

/// A unit step of speed at the time 0 that is spread over the time T. The entries are the distance travelled since −∞ and the first three
/// time derivatives of this distance.
using Spread = std::array<double, 4>;

/// Returns the spread step at the time u relative to the middle of the step, for u ≤ 0. The second half of the step is the mirror image of
/// the first half.
Spread before_middle(double u, double longer, double shorter) {
  const double flat = (longer - shorter) / 2, x = u + (longer + shorter) / 2, area = longer * shorter;
  if (x <= 0) return {};
  if (u < -flat) return {x * x * x / (6 * area), x * x / (2 * area), x / area, 1 / area};
  const double y = u + flat;
  return {shorter * shorter / (6 * longer) + y * (shorter + y) / (2 * longer), (shorter / 2 + y) / longer, 1 / longer, 0};
}

Spread spread_at(double u, double longer, double shorter) {
  if (u <= 0) return before_middle(u, longer, shorter);
  const Spread mirrored = before_middle(-u, longer, shorter);
  return {u + mirrored[0], 1 - mirrored[1], mirrored[2], -mirrored[3]};
}

}  // namespace

void ThreadChain::begin(const Axes& at) { knots_.assign(1, {0, at, {}, 0}); }

void ThreadChain::add(const Axes& to, double seconds, std::uint64_t tag) {
  Knot& from = knots_.back();
  Knot next{0, to, {}, tag};
  for (std::size_t a = 0; a < limits_.speed.size(); ++a) seconds = std::max(seconds, std::fabs(to[a] - from.at[a]) / limits_.speed[a]);
  if (!(seconds > 0)) return;
  for (std::size_t a = 0; a < limits_.speed.size(); ++a) from.speed[a] = (to[a] - from.at[a]) / seconds;
  from.tag = tag;
  next.time = from.time + seconds;
  knots_.push_back(next);
}

double ThreadChain::step(std::size_t knot, std::size_t axis) const {
  return knots_[knot].speed[axis] - (knot > 0 ? knots_[knot - 1].speed[axis] : 0);
}

/// Returns the durations W1 and W2 of the two pulses that spread speed steps of the sizes `steps`, one per axis, so that each axis keeps
/// its limits. `jerks` is the factor by which overlapping steps multiply the jerk.
ThreadChain::Weight ThreadChain::weight_of(const Axes& steps, double jerks) const {
  Weight weight;
  for (std::size_t a = 0; a < limits_.speed.size(); ++a)
    weight.longer = std::max({weight.longer, steps[a] / limits_.acceleration[a], std::sqrt(jerks * steps[a] / limits_.jerk[a])});
  for (std::size_t a = 0; a < limits_.speed.size(); ++a)
    weight.shorter = std::max(weight.shorter, jerks * steps[a] / (limits_.jerk[a] * weight.longer));
  return weight;
}

ThreadChain::Weight ThreadChain::weight() const {
  Axes steps{}, least{}, most_speed{};
  double shortest = seconds();
  for (std::size_t k = 0; k < knots_.size(); ++k) {
    if (k > 0) shortest = std::min(shortest, knots_[k].time - knots_[k - 1].time);
    for (std::size_t a = 0; a < limits_.speed.size(); ++a) {
      steps[a] = std::max(steps[a], std::fabs(step(k, a)));
      least[a] = std::min(least[a], knots_[k].speed[a]);
      most_speed[a] = std::max(most_speed[a], knots_[k].speed[a]);
    }
  }
  const Weight apart = weight_of(steps, 1);
  if (apart.time() <= shortest) return apart;
  for (std::size_t a = 0; a < limits_.speed.size(); ++a) steps[a] = most_speed[a] - least[a];
  // If spread steps overlap in time, the greatest difference of an axis' speeds counts as one step with twice the jerk.
  return weight_of(steps, 2);
}

double ThreadChain::ramp() const { return weight().time(); }

/// Returns the times, s, between which the acceleration of every axis changes linearly.
std::vector<double> ThreadChain::moments(const Weight& weight) const {
  const double half = weight.time() / 2, flat = (weight.longer - weight.shorter) / 2;
  std::vector<double> times;
  for (const Knot& knot : knots_)
    for (const double away : {-half, -flat, flat, half}) times.push_back(knot.time + away);
  std::sort(times.begin(), times.end());
  return times;
}

/// Appends the polynomials of the axis positions in the time from `from` to `to`, as functions of time.
///   over  index of the last knot (the junction of two threads) whose speed step is finished if `moves` is true; otherwise the index of the
///         first knot
void ThreadChain::add_shape(double from, double to, std::size_t over, bool moves, const Weight& weight, std::vector<double>& path) const {
  const std::size_t axes = limits_.speed.size(), row = path.size();
  const double middle = (from + to) / 2;
  path.resize(row + axes * TimedCells::terms);
  const auto add = [&](std::size_t a, double part, const Spread& spread) {
    double* const c = path.data() + row + a * TimedCells::terms;
    c[0] += part * spread[0], c[1] += part * spread[1], c[2] += part * spread[2] / 2, c[3] += part * spread[3] / 6;
  };
  for (std::size_t a = 0; a < axes; ++a) {
    add(a, knots_[over].at[a], {1, 0, 0, 0});
    if (moves) add(a, knots_[over].speed[a], {from - knots_[over].time, 1, 0, 0});
  }
  for (std::size_t k = moves ? over + 1 : over; k < knots_.size() && knots_[k].time - weight.time() / 2 < middle; ++k) {
    Spread spread = spread_at(from - knots_[k].time, weight.longer, weight.shorter);
    // The third derivative of a spread step is constant over the whole interval, so its value in the middle of the interval is used.
    spread[3] = spread_at(middle - knots_[k].time, weight.longer, weight.shorter)[3];
    for (std::size_t a = 0; a < axes; ++a) add(a, step(k, a), spread);
  }
}

TimedCells ThreadChain::cells() const {
  const Weight spread = weight();
  const std::vector<double> times = moments(spread);
  TimedCells cells;
  cells.axes = limits_.speed.size();
  std::size_t over = 0, piece = 0;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double from = times[i], to = times[i + 1], middle = (from + to) / 2;
    if (!(middle > from)) continue;
    while (over + 1 < knots_.size() && knots_[over + 1].time + spread.time() / 2 <= from) ++over;
    while (piece + 2 < knots_.size() && knots_[piece + 1].time <= middle) ++piece;
    const double speed = path_speed(knots_[piece].speed), seconds = to - from;
    // The distance along the cell is proportional to time, at the speed that the spindle demands.
    cells.laws.push_back({seconds, speed * seconds, true, speed, 0, 0});
    cells.sources.push_back({knots_[piece].tag, speed, Bend::none});
    const std::size_t row = cells.path.size();
    add_shape(from, to, over, knots_[over].time + spread.time() / 2 <= from, spread, cells.path);
    for (std::size_t c = row; c < cells.path.size(); ++c) cells.path[c] /= std::pow(speed, (c - row) % TimedCells::terms);
  }
  return cells;
}

}  // namespace kadr
