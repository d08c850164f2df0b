// Follows two paths in parallel: the free-space diagram of both, computed one column at a time. Used by compare/comparison; tested by
// tests/compare/path_match_test.cpp.

#include "compare/path_match.h"

#include <algorithm>
#include <vector>

namespace kadr {
namespace {

using Interval = CourseSpace::Interval;
constexpr std::size_t most_open = 20'000;  // greatest number of segments of one path that may be near a single position of the other path

// max_lag: greatest number of segments by which path b may lag behind path a. most_alike: greatest number of identical segments that are
// searched for a vertex far enough away to pass them without the free-space diagram.
constexpr std::size_t max_lag = 4, most_alike = 16;
constexpr double same_projection = 1e-12;  // distance between the paths, in mm, below which the distance counts as 0 and is not reported

Interval common(Interval a, double from) { return {std::max(a.first, from), a.last}; }

class FreeSpace {
 public:
  FreeSpace(CourseCursor& a, CourseCursor& b, const CourseSpace& space, double tolerance)
      : a_(a),
        b_(b),
        space_(space),
        tolerance_(tolerance),
        state_a_(a.item(0).state),
        state_b_(b.item(0).state),
        begins_a_(a.at()),
        begins_b_(b.at()) {}

  PathMatch go() {
    PathMatch result = go_on();
    note_reach(result);
    return result;
  }

 private:
  PathMatch go_on() {
    begin();
    while (goes_on(a_, state_a_, 0)) {
      if (pass_alike()) continue;
      if (column_.size() > most_open) return part();
      if (!advance()) {
        if (!ends_.empty()) return cut_a();
        return part();
      }
    }
    return cut_b();
  }

  static bool goes_on(CourseCursor& lane, const CourseState& state, std::size_t i) {
    const CourseItem& item = lane.item(i);
    return item.kind == CourseItem::Kind::move && item.state == state;
  }
  Interval free_of_b(const Axes& point, std::size_t j) { return space_.within(point, b_.begin(j), b_.item(j).to, tolerance_); }

  /// Moves along b while a remains at its start.
  void begin() {
    for (std::size_t j = 0; goes_on(b_, state_b_, j) && j <= most_open; ++j) {
      const Interval free = free_of_b(a_.at(), j);
      if (free.empty() || free.first > 0) break;
      column_.push_back(free);
      near_.push_back(tolerance_);
      if (free.last < 1) break;
    }
    // Both paths start at the same position, so this position is reachable. An empty column is due to rounding errors only.
    if (column_.empty()) column_.push_back({0, 0}), near_.push_back(tolerance_);
  }

  // Identical segments need not be searched. Assume that both paths are at the vertex v0, on the diagonal of the free space, and that
  // their next segments are the same, v0 v1 … vE. Then (v1, v1) can be reached, and everything that can be reached can be reached through
  // (v1, v1), if
  //   - vE is farther than the tolerance from every point of v0 v1, and
  //   - v2 … vE-1 are within the tolerance of v1.
  // Proof: take a path through the free space on which one of the two (a, say) is ahead. When b comes to v1, a has not passed vE, since a
  // could not pass vE while b was between v0 and v1. So a is then between v1 and vE, and all of that range within the tolerance of v1 is
  // connected: a gets there while b is at v1. If b has lagged behind v0, the same is true if vE is also farther than the tolerance from the
  // segments of b up to v0. Near a position where the paths differ there is no such vE within the identical segments: there the free space
  // decides as usual.

  /// Passes segments that are identical in both paths. Returns false, and changes nothing, if it cannot pass any.
  bool pass_alike() {
    std::size_t lag = 0;  // number of segments by which b lags behind a
    while (b_.begin(lag) != a_.at())
      if (++lag > max_lag || lag > column_.size()) return false;
    if (!is_reached(lag) || !are_alike(lag)) return false;
    pass_b(lag);
    do {
      a_.pass(), b_.pass();
      note_reach(result_);
    } while (are_alike(0));
    column_.clear(), near_.clear();
    begin();
    return true;
  }

  /// True if three conditions are met. Both paths can be at a's position; b can be ahead of this position only in a connected part of the
  /// free space; and every vertex of b that would be passed lies on a's path, so that no distance must be reported for it.
  bool is_reached(std::size_t lag) const {
    if (lag > 0) {
      if (column_[lag - 1].empty() || column_[lag - 1].last < 1) return false;
      for (std::size_t j = 0; j < lag; ++j)
        if (near_[j] > same_projection) return false;
    } else if (column_.empty() || column_.front().first > 0) {
      return false;
    }
    for (std::size_t j = lag; j < column_.size(); ++j)
      if (column_[j].first > 0 || column_[j].empty() || (column_[j].last < 1 && j + 1 < column_.size())) return false;
    return true;
  }

  /// True if the segments v0 v1 … vE are the same in both paths, where those of b start at index `lag`.
  bool are_alike(std::size_t lag) {
    for (std::size_t i = 0; i < most_alike; ++i) {
      const CourseItem &a = a_.item(i), &b = b_.item(lag + i);
      if (a.kind != CourseItem::Kind::move || b.kind != CourseItem::Kind::move || a.to != b.to || a.state != state_a_ ||
          b.state != state_b_)
        return false;
      if (i == 0) continue;
      const bool is_off = space_.is_off(a.to, a_.at(), a_.item(0).to, tolerance_);
      if (!is_off && space_.distance(a.to, a_.item(0).to) > tolerance_) return false;
      if (!is_off) continue;
      for (std::size_t j = 0; j < lag; ++j)
        if (!space_.is_off(a.to, b_.begin(j), b_.item(j).to, tolerance_)) return false;
      return true;
    }
    return false;
  }

  /// Follows a segment of a: computes the reachable intervals of b at the segment's end from the reachable intervals at its start.
  ///   returns  false if no interval at the end can be reached; `ends_` is then the part of a's segment from which the end of b can be
  ///            reached
  bool advance() {
    const Axes from = a_.at(), to = a_.item(0).to;
    next_.clear();
    ends_ = {};
    Interval bottom;
    if (!column_.front().empty() && column_.front().first <= 0) {
      bottom = space_.within(b_.at(), from, to, tolerance_);
      if (bottom.first > 0) bottom = {};
    }
    double nearest = tolerance_;
    bool any = false;
    for (std::size_t j = 0; j < column_.size() || !bottom.empty(); ++j) {
      if (!goes_on(b_, state_b_, j)) {
        ends_ = bottom;
        break;
      }
      const Interval left = j < column_.size() ? column_[j] : Interval{};
      if (near_.size() <= j) near_.push_back(tolerance_);
      const Interval right_free = free_of_b(to, j), top_free = space_.within(b_.item(j).to, from, to, tolerance_);
      const Interval right = !bottom.empty() ? right_free : !left.empty() ? common(right_free, left.first) : Interval{};
      const Interval top = !left.empty() ? top_free : !bottom.empty() ? common(top_free, bottom.first) : Interval{};
      if (!top.empty())
        near_[j] =
            std::min(near_[j], space_.distance(b_.item(j).to, space_.between(from, to, space_.nearest(b_.item(j).to, from, to, top))));
      if (!right.empty()) any = true, nearest = std::min(nearest, distance_to(to, j, right));
      next_.push_back(right);
      bottom = top;
    }
    if (!any) return false;
    a_.pass();
    note_reach(result_);
    result_.greatest = std::max(result_.greatest, nearest);
    std::swap(column_, next_);
    drop();
    return true;
  }

  void note_reach(PathMatch& result) const {
    result.reach = std::max({result.reach, space_.distance(begins_a_, a_.at()), space_.distance(begins_b_, b_.at())});
  }
  double distance_to(const Axes& point, std::size_t j, Interval in) {
    const Axes begin = b_.begin(j), end = b_.item(j).to;
    return space_.distance(point, space_.between(begin, end, space_.nearest(point, begin, end, in)));
  }

  /// Removes the leading segments of b that can no longer be reached.
  void drop() {
    std::size_t count = 0;
    while (count < column_.size() && column_[count].empty()) ++count;
    pass_b(count);
    while (!column_.empty() && column_.back().empty()) column_.pop_back();
  }
  void pass_b(std::size_t count) {
    for (std::size_t j = 0; j < count; ++j) result_.greatest = std::max(result_.greatest, near_[j]);
    column_.erase(column_.begin(), column_.begin() + std::ptrdiff_t(count));
    near_.erase(near_.begin(), near_.begin() + std::ptrdiff_t(std::min(count, near_.size())));
    b_.pass(count);
  }

  /// Moves b to its end if this end can be reached, else to the reachable position nearest to a. Called when a is at its end.
  void bring_b() {
    const std::size_t last = column_.size() - 1;
    if (!column_[last].empty() && column_[last].last >= 1 && goes_on(b_, state_b_, last) && !goes_on(b_, state_b_, last + 1))
      return pass_b(last + 1);
    std::size_t best = 0;
    double least = 1e300;
    for (std::size_t j = 0; j < column_.size(); ++j) {
      if (column_[j].empty() || !goes_on(b_, state_b_, j)) continue;
      if (const double d = distance_to(a_.at(), j, column_[j]); d <= least) least = d, best = j;
    }
    if (least > 1e299) return;
    const double part = space_.nearest(a_.at(), b_.begin(best), b_.item(best).to, column_[best]);
    pass_b(best);
    if (part > 0) b_.pass_part(part);
  }
  PathMatch cut_b() {
    bring_b();
    return result_;
  }
  /// Cuts the present segment of a in two. Called when b ends within this segment.
  PathMatch cut_a() {
    std::size_t last = 0;
    while (goes_on(b_, state_b_, last)) ++last;
    b_.pass(last);
    const Axes from = a_.at(), to = a_.item(0).to;
    const double part = space_.nearest(b_.at(), from, to, ends_);
    result_.greatest = std::max(result_.greatest, space_.distance(b_.at(), space_.between(from, to, part)));
    if (part > 0) a_.pass_part(part);
    return result_;
  }
  PathMatch part() {
    bring_b();
    result_.together = false;
    return result_;
  }

  CourseCursor& a_;
  CourseCursor& b_;
  const CourseSpace& space_;
  const double tolerance_;
  const CourseState state_a_, state_b_;
  const Axes begins_a_, begins_b_;
  // For each segment of b: the part of the segment that can be reached while a is at its present vertex
  std::vector<Interval> column_, next_;
  std::vector<double> near_;  // for each segment of b: the least distance from a at which the end of the segment can be passed
  Interval ends_;
  PathMatch result_;
};

}  // namespace

PathMatch match_paths(CourseCursor& a, CourseCursor& b, const CourseSpace& space, double tolerance) {
  return FreeSpace(a, b, space, tolerance).go();
}

}  // namespace kadr
