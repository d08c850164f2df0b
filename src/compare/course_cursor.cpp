// CourseCursor: a course with a current position and the items read ahead. Used by compare/comparison and compare/path_match.

#include "compare/course_cursor.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr double no_length = 1e-12;  // a segment whose squared length is less than this number of mm² counts as a point
constexpr double whole = 1 - 1e-9;   // a fraction of a segment that exceeds this counts as 1, because of rounding errors

}  // namespace

double CourseSpace::distance(const Axes& a, const Axes& b) const {
  double sum = 0;
  for (std::size_t i = 0; i < axes_; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

bool CourseSpace::is_off(const Axes& point, const Axes& from, const Axes& to, double most) const {
  double squared_length = 0, along = 0, sum = 0;
  for (std::size_t i = 0; i < axes_; ++i) {
    const double w = to[i] - from[i];
    squared_length += w * w, along += w * (point[i] - from[i]);
  }
  const double foot = along >= squared_length ? 1 : along <= 0 ? 0 : along / squared_length;
  for (std::size_t i = 0; i < axes_; ++i) {
    const double d = point[i] - from[i] - foot * (to[i] - from[i]);
    sum += d * d;
  }
  return sum > most * most;
}

Axes CourseSpace::between(const Axes& a, const Axes& b, double part) const {
  Axes at = b;
  for (std::size_t i = 0; i < axes_; ++i) at[i] = a[i] + part * (b[i] - a[i]);
  return at;
}

CourseSpace::Interval CourseSpace::within(const Axes& point, const Axes& from, const Axes& to, double most) const {
  double squared_length = 0, along = 0,
         off = 0;  // sums over the axes: squared_length = |to − from|², along = (point − from)·(to − from), off = |point − from|²
  for (std::size_t i = 0; i < axes_; ++i) {
    const double w = to[i] - from[i], p = point[i] - from[i];
    squared_length += w * w, along += p * w, off += p * p;
  }
  if (squared_length <= no_length) return off <= most * most ? Interval{0, 1} : Interval{};
  const double foot = along / squared_length, squared_distance = off - foot * along, free = most * most - squared_distance;
  if (!(free >= 0)) return {};
  const double half = std::sqrt(free / squared_length);
  return {std::max(foot - half, 0.0), std::min(foot + half, 1.0)};
}

double CourseSpace::nearest(const Axes& point, const Axes& from, const Axes& to, Interval in) const {
  double squared_length = 0, along = 0;
  for (std::size_t i = 0; i < axes_; ++i)
    squared_length += (to[i] - from[i]) * (to[i] - from[i]), along += (point[i] - from[i]) * (to[i] - from[i]);
  return squared_length <= no_length ? in.last : std::clamp(along / squared_length, in.first, in.last);
}

void CourseCursor::look_ahead(std::size_t i) {
  while (ahead_.size() <= i && (ahead_.empty() || ahead_.back().kind != CourseItem::Kind::end)) {
    const std::size_t before = ahead_.size();
    more_(ahead_);
    tidy(before);
  }
}

/// Removes motions of length 0 from the items whose index is `from` or greater.
void CourseCursor::tidy(std::size_t from) {
  std::size_t kept = from;
  for (std::size_t k = from; k < ahead_.size(); ++k) {
    CourseItem& item = ahead_[k];
    const Axes& before = kept == 0 ? at_ : ahead_[kept - 1].to;
    // The axes do not move during an act, but its position may be given in another coordinate frame, so the position before is used.
    if (item.kind != CourseItem::Kind::move) item.to = before;
    else if (item.to == before) continue;
    if (kept != k) ahead_[kept] = std::move(item);
    ++kept;
  }
  ahead_.cut(kept);
}

void CourseCursor::pass(std::size_t count) {
  for (; count > 0 && item(0).kind != CourseItem::Kind::end; --count) {
    const CourseItem& first = ahead_.front();
    if (first.kind == CourseItem::Kind::move && (first.origin.number != last_origin_.number || last_kind_ != CourseItem::Kind::move))
      ++moves_;
    if (on_pass) on_pass(first, at_, first.to);
    at_ = first.to;
    last_origin_ = first.origin, last_kind_ = first.kind;
    ahead_.pop_front();
  }
}

void CourseCursor::pass_part(double part) {
  if (part >= whole) return pass();
  CourseItem& first = ahead_.front();
  const Axes from = at_;
  at_ = space_.between(at_, first.to, part);
  if (on_pass) on_pass(first, from, at_);
  first.begins += part * (first.ends - first.begins);
}

}  // namespace kadr
