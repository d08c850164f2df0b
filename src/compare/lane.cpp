// A course that is looked ahead in. For compare/comparison, compare/stretch.

#include "compare/lane.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr double no_length = 1e-12;  // mm²: a piece without any
constexpr double whole = 1 - 1e-9;   // of a piece

}  // namespace

double CourseSpace::distance(const Axes& a, const Axes& b) const {
  double sum = 0;
  for (std::size_t i = 0; i < axes_; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

Axes CourseSpace::between(const Axes& a, const Axes& b, double part) const {
  Axes at = b;
  for (std::size_t i = 0; i < axes_; ++i) at[i] = a[i] + part * (b[i] - a[i]);
  return at;
}

CourseSpace::Interval CourseSpace::within(const Axes& point, const Axes& from, const Axes& to, double most) const {
  double way = 0, along = 0, off = 0;  // |to − from|², (point − from)·(to − from), |point − from|²
  for (std::size_t i = 0; i < axes_; ++i) {
    const double w = to[i] - from[i], p = point[i] - from[i];
    way += w * w, along += p * w, off += p * p;
  }
  if (way <= no_length) return off <= most * most ? Interval{0, 1} : Interval{};
  const double foot = along / way, beside = off - foot * along, free = most * most - beside;
  if (!(free >= 0)) return {};
  const double half = std::sqrt(free / way);
  return {std::max(foot - half, 0.0), std::min(foot + half, 1.0)};
}

double CourseSpace::nearest(const Axes& point, const Axes& from, const Axes& to, Interval in) const {
  double way = 0, along = 0;
  for (std::size_t i = 0; i < axes_; ++i) way += (to[i] - from[i]) * (to[i] - from[i]), along += (point[i] - from[i]) * (to[i] - from[i]);
  return way <= no_length ? in.last : std::clamp(along / way, in.first, in.last);
}

const CourseItem& Lane::item(std::size_t i) {
  while (ahead_.size() <= i) {
    CourseItem item = next_();
    const bool over = item.kind == CourseItem::Kind::end;
    const Axes& before = ahead_.empty() ? at_ : ahead_.back().to;
    if (item.kind != CourseItem::Kind::move) item.to = before;  // the frame may have changed; the axes stand
    else if (item.to == before) continue;
    ahead_.push_back(std::move(item));
    if (over) break;
  }
  return i < ahead_.size() ? ahead_[i] : ahead_.back();
}

void Lane::pass(std::size_t count) {
  for (; count > 0 && item(0).kind != CourseItem::Kind::end; --count) {
    CourseItem& first = ahead_.front();
    if (first.kind == CourseItem::Kind::move && (first.origin.number != last_.origin.number || last_.kind != CourseItem::Kind::move))
      ++moves_;
    if (on_pass) on_pass(first, at_, first.to);
    at_ = first.to;
    last_ = std::move(first);
    ahead_.pop_front();
  }
}

void Lane::pass_part(double part) {
  if (part >= whole) return pass();
  CourseItem& first = ahead_.front();
  const Axes from = at_;
  at_ = space_.between(at_, first.to, part);
  if (on_pass) on_pass(first, from, at_);
  first.begins += part * (first.ends - first.begins);
}

}  // namespace kadr
