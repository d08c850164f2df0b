#pragma once
// ItemRing: the items of a course in the look-ahead, in order. It reuses its memory: items that have been passed are overwritten, so that a
// long program needs no allocation for each of its blocks.

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "compare/course_item.h"

namespace kadr {

class ItemRing {
 public:
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  /// An item stays at its address until it is removed.
  CourseItem& operator[](std::size_t i) { return at(first_ + i); }
  CourseItem& front() { return at(first_); }
  CourseItem& back() { return at(first_ + size_ - 1); }

  /// Adds an item at the end. It still has its old contents, so every member must be written.
  CourseItem& add() {
    if (first_ + size_ == chunks_.size() * chunk) chunks_.push_back(std::make_unique<CourseItem[]>(chunk));
    return at(first_ + size_++);
  }
  void pop_front() {
    --size_;
    if (++first_ < chunk) return;
    first_ = 0;
    std::rotate(chunks_.begin(), chunks_.begin() + 1, chunks_.end());
  }
  /// Keeps only the first items.
  void cut(std::size_t size) { size_ = size; }

 private:
  static constexpr std::size_t chunk = 64;  // items
  CourseItem& at(std::size_t i) { return chunks_[i / chunk][i % chunk]; }

  std::vector<std::unique_ptr<CourseItem[]>> chunks_;  // those with items first, in order
  std::size_t first_ = 0, size_ = 0;                   // first_: index within the first chunk
};

}  // namespace kadr
