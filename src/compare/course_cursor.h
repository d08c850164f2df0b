#pragma once
// CourseCursor: one of the two courses of a comparison, with its current position and the items read ahead. A segment can be cut in two at
// any position.

#include <functional>

#include "compare/item_ring.h"

namespace kadr {

/// Measures distances between axis positions in mm; a degree of a rotary axis counts as 1 mm.
class CourseSpace {
 public:
  explicit CourseSpace(std::size_t axes) : axes_(axes) {}
  double distance(const Axes& a, const Axes& b) const;
  /// Returns true if the point is farther than `most` from every point of the segment `from` … `to`.
  bool is_off(const Axes& point, const Axes& from, const Axes& to, double most) const;
  Axes between(const Axes& a, const Axes& b, double part) const;
  /// The range of fractions (0 … 1) of a segment in which the segment is at most `most` mm away from a point; empty if first > last.
  struct Interval {
    double first = 1, last = 0;
    bool empty() const { return first > last; }
  };
  Interval within(const Axes& point, const Axes& from, const Axes& to, double most) const;
  /// Returns the fraction in the interval whose position is nearest to the point.
  double nearest(const Axes& point, const Axes& from, const Axes& to, Interval in) const;

 private:
  std::size_t axes_;
};

class CourseCursor {
 public:
  ///   more   appends the next items of a course in order (at least one), until its end
  ///   start  position at which the course begins
  CourseCursor(std::function<void(ItemRing&)> more, const Axes& start, const CourseSpace& space)
      : more_(std::move(more)), space_(space), at_(start) {}

  /// Returns the i-th item that is not passed yet; after the end of the course, the end item.
  const CourseItem& item(std::size_t i) {
    if (i >= ahead_.size()) look_ahead(i);
    return ahead_[i < ahead_.size() ? i : ahead_.size() - 1];
  }
  /// Returns the position at which the i-th item begins.
  const Axes& begin(std::size_t i) { return i == 0 ? at_ : item(i - 1).to; }
  const Axes& at() const { return at_; }
  void pass(std::size_t count = 1);
  /// Moves the cursor past a fraction of the first item, which must be a motion; the rest of the motion becomes the first item.
  void pass_part(double part);
  /// Number of motions passed; a motion cut in two counts once.
  std::size_t moves() const { return moves_; }
  /// Origin (file and line) of the last item passed.
  const Origin& last_origin() const { return last_origin_; }

  /// If set, called for each item, or part of one, that is passed, with its start and end positions.
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
