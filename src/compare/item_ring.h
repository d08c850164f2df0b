#pragma once
// ItemRing: the items of a course that have been read but not passed yet, in order. The memory of items that were passed is used again, so
// that a long program needs no memory allocation for each block.

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
  /// Returns the item with index i. Its address stays valid until the item is removed.
  CourseItem& operator[](std::size_t i) { return at(first_ + i); }
  CourseItem& front() { return at(first_); }
  CourseItem& back() { return at(first_ + size_ - 1); }

  /// Adds an item at the end and returns it. The item still contains the data of an earlier item, so the caller must set every member.
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
  /// Removes all items except the first `size` items.
  void cut(std::size_t size) { size_ = size; }

 private:
  static constexpr std::size_t chunk = 64;  // number of items in a chunk of memory
  CourseItem& at(std::size_t i) { return chunks_[i / chunk][i % chunk]; }

  std::vector<std::unique_ptr<CourseItem[]>> chunks_;  // chunks of memory: first those with items, in order, then free chunks
  std::size_t first_ = 0, size_ = 0;                   // first_: index of the first item within the first chunk; size_: number of items
};

}  // namespace kadr
