#pragma once
// Lane: a course with as much of it ahead as is looked at, and where it stands. Pieces can be cut in two.

#include <deque>
#include <functional>

#include "compare/course.h"

namespace kadr {

/// Positions as points: mm; a degree of a rotary axis counts as a mm.
class CourseSpace {
 public:
  explicit CourseSpace(std::size_t axes) : axes_(axes) {}
  double distance(const Axes& a, const Axes& b) const;
  Axes between(const Axes& a, const Axes& b, double part) const;
  /// Parts of the way from `from` to `to` that are within `most` of a point; empty: first > last.
  struct Interval {
    double first = 1, last = 0;
    bool empty() const { return first > last; }
  };
  Interval within(const Axes& point, const Axes& from, const Axes& to, double most) const;
  /// The part there that is nearest to the point.
  double nearest(const Axes& point, const Axes& from, const Axes& to, Interval in) const;

 private:
  std::size_t axes_;
};

class Lane {
 public:
  /// `next`: the items of a course in their order; `start`: where it begins.
  Lane(std::function<CourseItem()> next, const Axes& start, const CourseSpace& space) : next_(std::move(next)), space_(space), at_(start) {}

  /// Of those that have not been passed; the end again and again behind it.
  const CourseItem& item(std::size_t i);
  /// Where the i-th begins.
  const Axes& begin(std::size_t i) { return i == 0 ? at_ : item(i - 1).to; }
  const Axes& at() const { return at_; }
  void pass(std::size_t count = 1);
  /// Passes a part of the first one, a move.
  void pass_part(double part);
  /// Moves that have been passed, each once.
  std::size_t moves() const { return moves_; }
  const CourseItem& last() const { return last_; }

  /// Where set: called with each item that is passed, or a part of it, and where that begins and ends.
  std::function<void(const CourseItem& item, const Axes& from, const Axes& to)> on_pass;

 private:
  std::function<CourseItem()> next_;
  const CourseSpace& space_;
  Axes at_;
  std::deque<CourseItem> ahead_;
  CourseItem last_;
  std::size_t moves_ = 0;
};

}  // namespace kadr
