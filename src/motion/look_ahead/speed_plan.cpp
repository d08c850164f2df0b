// This file plans the speeds along a path of pieces, from a given speed to rest. Each piece has its own speed limit. Used by
// motion/look_ahead/look_ahead; tested by tests/motion/speed_plan_test.cpp.

#include "motion/look_ahead/speed_plan.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "base/vec.h"

namespace kadr {
namespace {

// Relative tolerance of lengths. Because of rounding errors, a change of speed may need slightly more length than the length from which the
// change was computed.
constexpr double rounding = 1e-9;

/// Returns true if two speeds differ by rounding errors only; the caller must then treat them as equal.
bool is_same(double a, double b) { return a == b || std::abs(a - b) <= rounding * std::max(a, b); }

/// Makes the speed limits of neighbouring pieces equal if they differ by rounding errors only.
void level(std::span<PathPiece> pieces) {
  for (std::size_t k = 1; k < pieces.size(); ++k)
    if (is_same(pieces[k].most, pieces[k - 1].most)) pieces[k].most = pieces[k - 1].most;
}

/// Returns the speed, mm/s, that is reached at the distance `length`, mm, in a ramp that starts at the speed `from`. The ramp leads to a
/// far higher speed, so it is not complete at this distance.
double passing(double from, double length, const Acceleration& acceleration) {
  if (std::isinf(acceleration.most)) return length > 0 ? acceleration.most : from;
  const double gain = std::sqrt(2 * acceleration.most * length);  // upper bound of the change of speed over the distance `length`, mm/s
  const Ramp ramp(from, from + gain + acceleration.most * acceleration.build_up, acceleration);
  return ramp.speed_at(ramp.seconds_at(length));
}

}  // namespace

void SpeedPlan::make(std::span<PathPiece> pieces, double start) {
  pieces_ = pieces;
  const std::size_t count = pieces.size();
  level(pieces);
  speed_.resize(count + 1);
  speed_.front() = start;
  for (std::size_t k = 1; k < count; ++k) speed_[k] = std::min({pieces[k - 1].most, pieces[k].most, pieces[k].enter});
  speed_.back() = 0;
  const auto smooth = [](const PathPiece& p) { return p.acceleration.build_up > 0; };
  if (std::any_of(pieces.begin(), pieces.end(), smooth)) make_smooth();
  else make_linear();
}

void SpeedPlan::make_linear() {
  const std::size_t count = pieces_.size();
  const auto cap = [&](std::size_t node, double from, const PathPiece& p) {
    speed_[node] = std::min(speed_[node], reached(from, p.length, p.acceleration));
  };
  for (std::size_t k = count; k-- > 1;) cap(k, speed_[k + 1], pieces_[k]);
  for (std::size_t k = 0; k + 1 < count; ++k) cap(k + 1, speed_[k], pieces_[k]);
  for (std::size_t k = 0; k < count; ++k) {
    PathPiece& p = pieces_[k];
    p.end = speed_[k + 1];
    p.top = top_speed(speed_[k], p.end, p.length, p.most, p.acceleration);
    p.seconds = travel_seconds(speed_[k], p.end, p.length, p.most, p.acceleration);
    p.steady = true;
  }
}

/// Returns the lowest acceleration and the longest build-up time of several pieces. A ramp with these two values exceeds no axis' limits in
/// any of the pieces.
Acceleration SpeedPlan::gentlest(std::size_t first, std::size_t last) const {
  Acceleration all = pieces_[first].acceleration;
  for (std::size_t k = first + 1; k < last; ++k) {
    all.most = std::min(all.most, pieces_[k].acceleration.most);
    all.build_up = std::max(all.build_up, pieces_[k].acceleration.build_up);
  }
  return all;
}

/// Returns an acceleration that no ramp through these pieces can exceed. A jerk-free ramp is bounded by its greatest jerk, which is π/2
/// times its mean jerk.
Acceleration SpeedPlan::liveliest(std::size_t first, std::size_t last) const {
  Acceleration all = pieces_[first].acceleration;
  for (std::size_t k = first + 1; k < last; ++k) {
    all.most = std::max(all.most, pieces_[k].acceleration.most);
    all.build_up = std::min(all.build_up, pieces_[k].acceleration.build_up);
  }
  if (std::exchange(all.jerk_free, false)) all.build_up *= 2 / pi;
  return all;
}

/// Returns true if the speed limit is the same before and after the node. Such a node needs no anchor (point of zero acceleration), so a
/// line that is divided into two pieces is planned as one piece.
bool SpeedPlan::is_anchor_free(std::size_t node) const {
  return is_same(speed_[node], pieces_[node - 1].most) && is_same(speed_[node], pieces_[node].most);
}

/// Places an anchor (a point of zero acceleration) at the node. If a complete ramp can reach the speed limit of the node, the anchor has
/// this speed. If only a ramp that continues beyond the node can reach the limit, the anchor has the speed that a complete ramp reaches. If
/// no ramp can reach the limit, the node gets no anchor.
void SpeedPlan::place_anchor(std::size_t node) {
  std::size_t before = node - 1, after = node + 1;
  while (!anchor_[before]) --before;
  while (!anchor_[after]) ++after;
  const double from = speed_[before], to = speed_[after], up = distance(before, node), down = distance(node, after);
  const double even = std::min(reached(from, up, gentlest(before, node)), reached(to, down, gentlest(node, after)));
  if (speed_[node] > even) {
    if (speed_[node] >= std::min(passing(from, up, liveliest(before, node)), passing(to, down, liveliest(node, after)))) return;
    speed_[node] = even;
  }
  anchor_[node] = true;
}

void SpeedPlan::make_smooth() {
  const std::size_t count = pieces_.size();
  at_.assign(1, 0);
  for (const PathPiece& p : pieces_) at_.push_back(at_.back() + p.length);
  anchor_.assign(count + 1, false);
  anchor_.front() = anchor_.back() = true;
  order_.clear();
  for (std::size_t k = 1; k < count; ++k)
    if (!is_anchor_free(k)) order_.push_back(k);
  const auto from_end = [&](std::size_t node) { return std::min(at_[node], at_.back() - at_[node]); };
  std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) { return speed_[a] < speed_[b]; });
  // An anchor is a point of the path where the acceleration is zero. The nodes get anchors in ascending order of their speed limits. Nodes
  // with equal limits are processed from both ends of the path inwards, so that the plan is symmetric.
  for (auto same = order_.begin(); same != order_.end();) {
    auto end = std::next(same);
    while (end != order_.end() && is_same(speed_[*end], speed_[*std::prev(end)])) ++end;
    std::sort(same, end, [&](std::size_t a, std::size_t b) { return from_end(a) != from_end(b) ? from_end(a) < from_end(b) : a < b; });
    same = end;
  }
  for (const std::size_t node : order_) place_anchor(node);
  for (std::size_t first = 0, last = 1; last <= count; ++last) {
    if (!anchor_[last]) continue;
    fill(first, last);
    first = last;
  }
}

/// Plans the speeds between two anchors (points of zero acceleration). The ramps do not reach the speed limits between the anchors, so only
/// the limits of the pieces at the top speed count. A plan may start in the middle of an older plan, at an instant at which the speed was
/// falling. A complete ramp may then need more length than is available. In this case the speed changes linearly, with slightly more
/// acceleration than allowed.
void SpeedPlan::fill(std::size_t first, std::size_t last) {
  const double from = speed_[first], to = speed_[last], length = distance(first, last);
  Acceleration a = gentlest(first, last);
  if (ramp_length(from, to, a) > length * (1 + rounding)) a = {std::abs(to - from) * (to + from) / (2 * length)};
  double most = 0, top = 0, up_length = 0, down_at = 0;
  for (std::size_t k = first; k < last; ++k) most = std::max(most, pieces_[k].most);
  for (bool fits = false; !fits;) {
    fits = true;
    top = top_speed(from, to, length, most, a);
    up_length = ramp_length(from, top, a);
    down_at = std::max(length - ramp_length(top, to, a), up_length);
    for (std::size_t k = first; k < last; ++k) {
      const bool at_top = at_[k] - at_[first] <= down_at && at_[k + 1] - at_[first] >= up_length;
      if (!at_top || pieces_[k].most >= top || most <= std::max(from, to)) continue;
      most = pieces_[k].most;
      fits = false;
      break;
    }
  }
  const Ramp up(from, top, a), down(top, to, a);
  const double even = (down_at - up_length) / top, all = up.seconds() + even + down.seconds();
  double passed = 0, speed = from;
  for (std::size_t k = first; k < last; ++k) {
    PathPiece& p = pieces_[k];
    const double start = at_[k] - at_[first], end = at_[k + 1] - at_[first];
    const double up_time = up.seconds_at(end), down_time = down.seconds_at(end - down_at);
    const double time = k + 1 == last ? all : up_time + std::clamp((end - up_length) / top, 0.0, even) + down_time;
    p.seconds = time - passed;
    p.end = k + 1 == last ? to : end < up_length ? up.speed_at(up_time) : down.speed_at(down_time);
    p.top = start <= down_at && end >= up_length ? top : std::max(speed, p.end);
    p.steady = end <= down_at || k + 1 == last;
    passed = time;
    speed = p.end;
  }
}

}  // namespace kadr
