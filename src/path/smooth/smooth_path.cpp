// SmoothPath: a path of straight pieces in the axes' space, its corners rounded within a tolerance (path/smooth/soft_corner). For
// motion/least_time/planner; tested by tests/path/smooth_path_test.cpp.

#include "path/smooth/smooth_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "action/action.h"
#include "path/smooth/soft_corner.h"

namespace kadr {
namespace {

constexpr double shortest = 1e-9;        // mm: a shorter piece has no direction worth the name
constexpr double same_feed = 1e-6;       // relative: rounding of a way divided by its time
constexpr double straight_bend = 1e-12;  // |Δu| of pieces that go on straight but for rounding

}  // namespace

void SmoothPath::begin(const double* at) {
  point_.assign(at, at + axes_);
  bend_.assign(axes_, 0);
  for (std::vector<double>* const of_vertices : {&turn_, &at_, &width_, &tolerance_, &room_}) of_vertices->assign(1, 0);
  direction_.clear();
  length_.clear();
  feed_.clear();
  tag_.clear();
  on_curve_.assign(1, 0);
  paced_.assign(1, 0);
  done_ = 1;
  settled_ = 0;
}

void SmoothPath::line_to(const double* to, double feed, double tolerance, bool on_curve, std::uint64_t tag, bool paced) {
  const std::size_t last = pieces() * axes_;
  double squares = 0;
  for (std::size_t a = 0; a < axes_; ++a) squares += (to[a] - point_[last + a]) * (to[a] - point_[last + a]);
  const double length = std::sqrt(squares);
  if (!(length > shortest)) return;
  for (std::size_t a = 0; a < axes_; ++a) direction_.push_back((to[a] - point_[last + a]) / length);
  if (!length_.empty()) {
    squares = 0;
    for (std::size_t a = 0; a < axes_; ++a) {
      bend_[last + a] = direction_[last + a] - direction_[last - axes_ + a];
      squares += bend_[last + a] * bend_[last + a];
    }
    turn_.back() = std::sqrt(squares);
    tolerance_.back() = tolerance;
    on_curve_.back() = on_curve ? 1 : 0;
    paced_.back() = paced ? 1 : 0;
  }
  point_.insert(point_.end(), to, to + axes_);
  bend_.insert(bend_.end(), axes_, 0);
  for (std::vector<double>* const of_vertices : {&turn_, &width_, &tolerance_, &room_}) of_vertices->push_back(0);
  at_.push_back(at_.back() + length);
  length_.push_back(length);
  feed_.push_back(feed);
  tag_.push_back(tag);
  on_curve_.push_back(0);
  paced_.push_back(0);
}

std::size_t SmoothPath::piece_at(double s, std::size_t from) const {
  while (from + 1 < length_.size() && at_[from + 1] <= s) ++from;
  return from;
}

bool SmoothPath::is_one_line() const {
  for (std::size_t i = 1; i < length_.size(); ++i)
    if (turn_[i] > straight_bend || std::fabs(feed_[i] - feed_[0]) > same_feed * feed_[0]) return false;
  return !length_.empty();
}

/// The inner vertices within `reach` of s; `around`: the piece that holds it.
template <class Take>
void SmoothPath::corners_near(double s, std::size_t around, double reach, const Take& take) const {
  for (std::size_t i = around + 1; i-- > 1 && s - at_[i] < reach;) take(i);
  for (std::size_t i = around + 1; i + 1 < at_.size() && at_[i] - s < reach; ++i) take(i);
}

/// How far the roundings move the path at s, mm.
double SmoothPath::moved(double s, std::size_t around) const {
  std::array<double, max_axes> sum{};
  corners_near(s, around, reach_, [&](std::size_t i) {
    const Rounding& rounding = roundings_[i];
    const double part = std::fabs(s - at_[i]) * rounding.inverse;
    if (!(part < 1)) return;
    const double g = width_[i] * rounding.shape->height(part);
    for (std::size_t a = 0; a < axes_; ++a) sum[a] += bend_[i * axes_ + a] * g;
  });
  double squares = 0;
  for (std::size_t a = 0; a < axes_; ++a) squares += sum[a] * sum[a];
  return std::sqrt(squares);
}

/// How far the roundings move the path to one side of a vertex at most, mm: looked at in places as dense as its own rounding asks for where
/// that is felt, but not beyond a vertex that asks for as much, and in some between there and half the way to the next vertex.
double SmoothPath::moved_beside(std::size_t vertex, int side) const {
  constexpr int places = 6;   // from the vertex to where it swings out
  constexpr int farther = 4;  // after that
  const double step = SoftCorner::of(turn_[vertex]).flank() * width_[vertex] / places, felt = (places + 1) * step;
  const std::size_t beside = side < 0 ? vertex - 1 : vertex;
  std::size_t next = side < 0 ? vertex - 1 : vertex + 1, piece = beside;
  double most = 0;
  for (int k = 1; k <= places + 1; ++k) {
    const double s = at_[vertex] + side * k * step;
    while (side * (s - at_[next]) > 0 && next > 0 && next + 1 < at_.size() && width_[next] > 2 * width_[vertex])
      side < 0 ? (--next, --piece) : (++next, ++piece);
    if (side * (s - at_[next]) > 0) break;
    most = std::max(most, moved(s, piece));
  }
  const double behind = std::min(length_[beside] / 2, reach_) - felt;
  for (int k = 1; k <= farther && behind > 0; ++k) most = std::max(most, moved(at_[vertex] + side * (felt + k * behind / farther), beside));
  return most;
}

/// Another rounding is felt where this one is.
bool SmoothPath::overlaps(std::size_t vertex) const {
  bool any = false;
  corners_near(at_[vertex], vertex, width_[vertex] + reach_,
               [&](std::size_t k) { any = any || (k != vertex && std::fabs(at_[k] - at_[vertex]) < width_[k] + width_[vertex]); });
  return any;
}

void SmoothPath::look_at_roundings() {
  roundings_.resize(at_.size());
  for (std::size_t i = 0; i < at_.size(); ++i) {
    constexpr double none = std::numeric_limits<double>::infinity();
    roundings_[i] = {width_[i] > 0 ? 1 / width_[i] : none, &SoftCorner::of(turn_[i])};
  }
}

/// Makes roundings narrower where they move the path further than the tolerance. False: none does.
bool SmoothPath::shrink(std::size_t first, std::size_t end) {
  constexpr double rounding = 1e-9;  // relative: of an even split that meets the tolerance exactly
  constexpr double far_off = 1.3;    // of the tolerance; nearer it goes in small steps, so that what matters most stays widest
  constexpr double between = 0.99;   // of the tolerance: the rest is for what lies between the places looked at
  constexpr double aim = 0.999;      // of that, so that the rounds come to an end
  bool any = false;
  look_at_roundings();
  factor_.assign(at_.size(), 1);
  for (std::size_t i = first; i < end; ++i) {
    if (!overlaps(i)) continue;  // alone it is as wide as the tolerance allows
    const double most = std::max({moved(at_[i], i), moved_beside(i, -1), moved_beside(i, 1)}), allowed = between * tolerance_[i];
    if (most <= allowed * (1 + rounding)) continue;
    any = true;
    const double less = std::pow(aim * allowed / most, most > far_off * allowed ? 0.5 : 0.2);  // several corners bear it together
    const double far = width_[i];
    corners_near(at_[i], i, 2 * reach_, [&](std::size_t k) {
      if (k >= done_ && std::fabs(at_[k] - at_[i]) < width_[k] + far) factor_[k] = std::min(factor_[k], less);
    });
  }
  if (any)
    for (std::size_t i = done_; i < at_.size(); ++i) width_[i] *= factor_[i];
  return any;
}

/// A chain of chords of a circle is moved by curvature · w² · second_moment.
double SmoothPath::width_on_curve(std::size_t vertex) const {
  constexpr double used = 0.9;  // of the tolerance: the rest is for where the curve begins and ends
  const double length = (length_[vertex - 1] + length_[vertex]) / 2;
  return std::sqrt(used * tolerance_[vertex] * length / (SoftCorner::of(turn_[vertex]).second_moment() * turn_[vertex]));
}

void SmoothPath::settle(bool last, StopToken stop) {
  const std::size_t vertices = at_.size();
  std::size_t first = std::max<std::size_t>(done_, 1);
  double edge = 0;  // the last length that no rounding reaches over
  for (std::size_t i = first; i-- > 0 && edge == 0 && at_[first] - at_[i] < widest;)
    if (turns_back(i)) edge = at_[i];
  for (std::size_t i = first; i + 1 < vertices; ++i) {
    room_[i] = at_[i] - edge;
    width_[i] = turn_[i] > straight_bend ? std::min(widest, at_[i] - edge) : 0;
    if (turns_back(i)) width_[i] = 0, edge = at_[i];
    else if (width_[i] > 0 && on_curve(i)) width_[i] = std::min(width_[i], width_on_curve(i));
    else if (width_[i] > 0) width_[i] = std::min(width_[i], tolerance_[i] / (SoftCorner::of(turn_[i]).highest() * turn_[i]));
  }
  room_.back() = at_.back() - edge;
  edge = last ? at_.back() : at_.back() + widest;
  for (std::size_t i = vertices - 1; i-- > first;) {
    room_[i] = std::min(room_[i], edge - at_[i]);
    width_[i] = std::min(width_[i], edge - at_[i]);
    if (turns_back(i)) edge = at_[i];
  }
  if (first == 1) room_[0] = edge - at_[0];
  reach_ = *std::max_element(width_.begin(), width_.end());
  constexpr int most_rounds = 200;  // a chain needs ten to thirty
  for (int round = 0; round < most_rounds && !stop.asked() && shrink(first, vertices - 1); ++round) {
  }
  settled_ = last ? at_.back() : std::max(settled_, at_.back() - 3 * widest);
  while (done_ < vertices && (last || at_[done_] < settled_ + widest)) ++done_;
}

void SmoothPath::forget(double before) {
  std::size_t drop = 0;
  while (drop + 1 < length_.size() && at_[drop + 1] < before - 4 * widest) ++drop;
  if (drop == 0) return;
  const auto cut = [](auto& v, std::size_t n) { v.erase(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(n)); };
  for (std::vector<double>* const of_axes : {&point_, &bend_, &direction_}) cut(*of_axes, drop * axes_);
  for (std::vector<double>* const one : {&turn_, &at_, &width_, &tolerance_, &room_, &length_, &feed_}) cut(*one, drop);
  cut(tag_, drop);
  cut(on_curve_, drop);
  cut(paced_, drop);
  done_ -= std::min(done_, drop);
}

/// From a point to the nearest one of a piece, mm².
double SmoothPath::squared_way_to(std::size_t piece, const double* x) const {
  const double* const start = point_.data() + piece * axes_;
  double along = 0, squares = 0;
  for (std::size_t a = 0; a < axes_; ++a) along += (x[a] - start[a]) * direction(piece)[a];
  along = std::clamp(along, 0.0, length_[piece]);
  for (std::size_t a = 0; a < axes_; ++a) {
    const double off = x[a] - start[a] - along * direction(piece)[a];
    squares += off * off;
  }
  return squares;
}

double SmoothPath::beyond(double s, std::size_t piece, const double* x) const {
  double least = squared_way_to(piece, x), tolerance = 0;
  if (least == 0) return 0;
  corners_near(s, piece, reach_, [&](std::size_t i) {
    if (std::fabs(s - at_[i]) < width_[i]) tolerance = std::max(tolerance, tolerance_[i]);
  });
  if (tolerance == 0 || least <= tolerance * tolerance) return 0;
  const double around = 4 * std::sqrt(least);  // of s: the nearest piece, but where the path comes back to the same place
  for (std::size_t i = piece; i-- > 0 && s - at_[i + 1] < around;) least = std::min(least, squared_way_to(i, x));
  for (std::size_t i = piece + 1; i < pieces() && at_[i] - s < around; ++i) least = std::min(least, squared_way_to(i, x));
  return std::max(0.0, std::sqrt(least) / tolerance - 1);
}

void SmoothPath::evaluate(double s, std::size_t piece, double* x, double* x1, double* x2) const {
  const double along = s - at_[piece];
  for (std::size_t a = 0; a < axes_; ++a) {
    x1[a] = direction_[piece * axes_ + a];
    x[a] = point_[piece * axes_ + a] + along * x1[a];
    x2[a] = 0;
  }
  corners_near(s, piece, reach_, [&](std::size_t i) {
    const double w = width_[i], offset = s - at_[i], away = std::fabs(offset);
    if (away >= w) return;
    const SoftCorner::Shape shape = SoftCorner::of(turn_[i]).at(away / w);
    const double g = w * shape.g, g1 = offset > 0 ? -shape.slope : shape.slope, g2 = shape.pulse / w;
    const double* const bend = bend_.data() + i * axes_;
    for (std::size_t a = 0; a < axes_; ++a) {
      x[a] += bend[a] * g;
      x1[a] += bend[a] * g1;
      x2[a] += bend[a] * g2;
    }
  });
}

double SmoothPath::feed_at(double s, std::size_t piece) const {
  double pace = 1 / feed_[piece];
  corners_near(s, piece, reach_, [&](std::size_t i) {
    const double w = width_[i], offset = s - at_[i], away = std::fabs(offset);
    if (paced_[i] == 0 || away >= w) return;
    const double slope = SoftCorner::of(turn_[i]).at(away / w).slope;
    pace += (1 / feed_[i] - 1 / feed_[i - 1]) * (offset > 0 ? -slope : slope);
  });
  return pace > 0 ? 1 / pace : feed_[piece];
}

}  // namespace kadr
