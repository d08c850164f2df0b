// SmoothPath is a path of straight pieces in the axes' space whose corners are rounded within a tolerance (path/smooth/soft_corner). Used
// by motion/least_time/planner; tested by tests/path/smooth_path_test.cpp.

#include "path/smooth/smooth_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "action/action.h"
#include "path/smooth/soft_corner.h"

namespace kadr {
namespace {

constexpr double shortest = 1e-9;  // Length in mm. A piece that is shorter has no meaningful direction, so it is ignored.
// Relative difference of feeds that count as equal. Small differences occur because a feed is calculated as length / time.
constexpr double same_feed = 1e-6;
// The change of direction |Δu| below which two pieces count as collinear. The value allows for rounding errors.
constexpr double straight_bend = 1e-12;

}  // namespace

void SmoothPath::begin(const double* at) {
  point_.assign(at, at + axes_);
  bend_.assign(axes_, 0);
  for (std::vector<double>* const of_vertices : {&turn_, &at_, &squeezed_, &width_, &in_chain_, &tolerance_, &room_})
    of_vertices->assign(1, 0);
  direction_.clear();
  length_.clear();
  feed_.clear();
  tag_.clear();
  on_curve_.assign(1, 0);
  paced_.assign(1, 0);
  is_chained_.assign(1, 0);
  marks_.clear();
  sums_.forget();
  slow_.begin();
  last_width_ = widest;
  done_ = 1;
  settled_ = 0;
  forgotten_ = 0;
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
  for (std::vector<double>* const of_vertices : {&turn_, &width_, &in_chain_, &tolerance_, &room_}) of_vertices->push_back(0);
  at_.push_back(at_.back() + length);
  squeezed_.push_back(squeezed_.back() + std::min(length, squeezed_to));
  length_.push_back(length);
  feed_.push_back(feed);
  tag_.push_back(tag);
  on_curve_.push_back(0);
  paced_.push_back(0);
  is_chained_.push_back(0);
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

/// Converts the path length s to the length that slow_ uses. In this length, pieces longer than squeezed_to are shortened: their middle is
/// omitted.
double SmoothPath::squeezed(double s, std::size_t piece) const {
  const double along = s - at_[piece], length = length_[piece];
  if (length <= squeezed_to) return squeezed_[piece] + along;
  return along < length / 2 ? squeezed_[piece] + std::min(along, squeezed_to / 2)
                            : squeezed_[piece + 1] - std::min(length - along, squeezed_to / 2);
}

void SmoothPath::forget(double before) {
  std::size_t drop = 0;
  while (drop + 1 < length_.size() && at_[drop + 1] < before - 4 * widest) ++drop;
  if (drop == 0) return;
  forgotten_ += drop;
  const auto cut = [](auto& v, std::size_t n) { v.erase(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(n)); };
  for (std::vector<double>* const of_axes : {&point_, &bend_, &direction_}) cut(*of_axes, drop * axes_);
  for (std::vector<double>* const one : {&turn_, &at_, &squeezed_, &width_, &in_chain_, &tolerance_, &room_, &length_, &feed_})
    cut(*one, drop);
  cut(tag_, drop);
  cut(on_curve_, drop);
  cut(paced_, drop);
  cut(is_chained_, drop);
  done_ -= std::min(done_, drop);
  slow_.forget(squeezed_.front());
  const auto kept = std::lower_bound(marks_.begin(), marks_.end(), drop);
  marks_.erase(marks_.begin(), kept);
  for (std::size_t& mark : marks_) mark -= drop;
}

/// Returns the squared distance, mm², of a point from a piece.
double SmoothPath::squared_distance_to(std::size_t piece, const double* x) const {
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

/// Returns the greatest tolerance, mm, of the corners whose roundings cover the path length s.
double SmoothPath::tolerance_at(double s, std::size_t piece) const {
  const double chain = width_at(s, piece).w;
  double tolerance = 0;
  corners_near(s, piece, widest, [&](std::size_t i) {
    if (std::fabs(s - at_[i]) < (is_chained_[i] != 0 ? chain : width_[i])) tolerance = std::max(tolerance, tolerance_[i]);
  });
  return tolerance;
}

double SmoothPath::beyond(double s, std::size_t piece, const double* x, double part) const {
  double least = squared_distance_to(piece, x);
  if (least == 0) return 0;
  const double tolerance = part * tolerance_at(s, piece);
  if (tolerance == 0 || least <= tolerance * tolerance) return 0;
  // Extent of the search to both sides of s, mm. The search finds the nearest piece, unless the path returns to the same position later.
  const double around = 4 * std::sqrt(least);
  for (std::size_t i = piece; i-- > 0 && s - at_[i + 1] < around;) least = std::min(least, squared_distance_to(i, x));
  for (std::size_t i = piece + 1; i < pieces() && at_[i] - s < around; ++i) least = std::min(least, squared_distance_to(i, x));
  return std::max(0.0, std::sqrt(least) / tolerance - 1);
}

void SmoothPath::evaluate(double s, std::size_t piece, double* x, double* x1, double* x2) {
  const double along = s - at_[piece];
  for (std::size_t a = 0; a < axes_; ++a) {
    x1[a] = direction_[piece * axes_ + a];
    x[a] = point_[piece * axes_ + a] + along * x1[a];
    x2[a] = 0;
  }
  sums_.move(chained(), s, width_at(s, piece), x, x1, x2);
  if (reach_ == 0) return;
  corners_near(s, piece, reach_, [&](std::size_t i) {
    const double w = width_[i], away = std::fabs(s - at_[i]);
    if (is_chained_[i] != 0 || away >= w) return;
    const SoftCorner::Shape shape = SoftCorner::of(turn_[i]).at(away / w);
    const double g = w * shape.g, g1 = i <= piece ? -shape.slope : shape.slope, g2 = shape.pulse / w;
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
  const double chain_width = width_at(s, piece).w;
  corners_near(s, piece, widest, [&](std::size_t i) {
    const double w = is_chained_[i] != 0 ? chain_width : width_[i], away = std::fabs(s - at_[i]);
    if (paced_[i] == 0 || away >= w) return;
    const double slope = SoftCorner::of(turn_[i]).at(away / w).slope;
    pace += (1 / feed_[i] - 1 / feed_[i - 1]) * (i <= piece ? -slope : slope);
  });
  return pace > 0 ? 1 / pace : feed_[piece];
}

}  // namespace kadr
