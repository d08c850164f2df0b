#pragma once
// CourseCursor: one of the two courses of a comparison, with its current position and the items read ahead. A segment can be cut in two at
// any position.

#include <functional>

#include "compare/item_ring.h"

namespace kadr {

/// Measures distances between axis positions in mm. A degree of a rotary axis counts as 1 mm.
class CourseSpace {
 public:
  explicit CourseSpace(std::size_t axes) : axes_(axes) {}
  double distance(const Axes& a, const Axes& b) const;
  /// Returns true if every point of the segment `from` … `to` is farther than `most` (mm) from `point`.
  bool is_off(const Axes& point, const Axes& from, const Axes& to, double most) const;
  Axes between(const Axes& a, const Axes& b, double part) const;
  /// A range of fractions (0 to 1) of a segment: the part that is at most `most` mm away from a point. It is empty if first > last.
  struct Interval {
    double first = 1, last = 0;
    bool empty() const { return first > last; }
  };
  Interval within(const Axes& point, const Axes& from, const Axes& to, double most) const;
  /// Returns the fraction (0 to 1) at which the segment from `from` to `to` is nearest to `point`. Only fractions in the interval `in` are
  /// considered.
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

  /// Returns the item at index i of those that the cursor has not passed; after the end of the course, the end item.
  const CourseItem& item(std::size_t i) {
    if (i >= ahead_.size()) look_ahead(i);
    return ahead_[i < ahead_.size() ? i : ahead_.size() - 1];
  }
  /// Returns the position at which the item with index i begins.
  const Axes& begin(std::size_t i) { return i == 0 ? at_ : item(i - 1).to; }
  const Axes& at() const { return at_; }
  void pass(std::size_t count = 1);
  /// Moves the cursor past a fraction (0 to 1) of the first item, which must be a motion. The rest of the motion becomes the first item.
  void pass_part(double part);
  /// Returns the number of motions passed; a motion cut in two counts once.
  std::size_t moves() const { return moves_; }
  /// Returns the origin (file and line) of the last item passed.
  const Origin& last_origin() const { return last_origin_; }

  /// Called, if set, for each item or part of an item that the cursor passes, with the start and end positions of this part.
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
