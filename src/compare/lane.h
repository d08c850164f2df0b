#pragma once
// Lane: one of the two courses of a comparison, with its look-ahead and the current position. Pieces can be cut in two.

#include <functional>

#include "compare/item_ring.h"

namespace kadr {

/// Treats positions as points: mm; a degree of a rotary axis counts as a mm.
class CourseSpace {
 public:
  explicit CourseSpace(std::size_t axes) : axes_(axes) {}
  double distance(const Axes& a, const Axes& b) const;
  /// Returns true if a point is farther than `most` from every point between `from` and `to`.
  bool is_off(const Axes& point, const Axes& from, const Axes& to, double most) const;
  Axes between(const Axes& a, const Axes& b, double part) const;
  /// The part of the segment from `from` to `to` that is within `most` of a point; empty: first > last.
  struct Interval {
    double first = 1, last = 0;
    bool empty() const { return first > last; }
  };
  Interval within(const Axes& point, const Axes& from, const Axes& to, double most) const;
  /// Returns the fraction within the interval that is nearest to the point.
  double nearest(const Axes& point, const Axes& from, const Axes& to, Interval in) const;

 private:
  std::size_t axes_;
};

class Lane {
 public:
  ///   more   adds the next items of a course in order, one or more, up to its end
  ///   start  where the course begins
  Lane(std::function<void(ItemRing&)> more, const Axes& start, const CourseSpace& space)
      : more_(std::move(more)), space_(space), at_(start) {}

  /// Returns an item not yet passed; after the end, the end again.
  const CourseItem& item(std::size_t i) {
    if (i >= ahead_.size()) look_ahead(i);
    return ahead_[i < ahead_.size() ? i : ahead_.size() - 1];
  }
  /// Returns where the i-th item begins.
  const Axes& begin(std::size_t i) { return i == 0 ? at_ : item(i - 1).to; }
  const Axes& at() const { return at_; }
  void pass(std::size_t count = 1);
  /// Passes a part of the first item, which must be a move.
  void pass_part(double part);
  /// Number of moves passed, each counted once.
  std::size_t moves() const { return moves_; }
  /// Origin of the last item passed.
  const Origin& last_origin() const { return last_origin_; }

  /// If set, called with each item or part of an item that is passed, and its start and end positions.
  std::function<void(const CourseItem& item, const Axes& from, const Axes& to)> on_pass;

 private:
  void look_ahead(std::size_t i);
  void tidy(std::size_t from);

  std::function<void(ItemRing&)> more_;
  const CourseSpace& space_;
  Axes at_;
  ItemRing ahead_;
  Origin last_origin_;
  CourseItem::Kind last_kind_ = CourseItem::Kind::end;
  std::size_t moves_ = 0;
};

}  // namespace kadr
