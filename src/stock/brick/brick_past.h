#pragma once
// BrickPast: the history of a brick, so that it can be restored as it was at any sweep.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "stock/brick/brick.h"

namespace kadr {

/// The brick as it was after this number of its cuts.
struct BrickCopy {
  std::size_t cuts;
  std::unique_ptr<Brick> brick;
};

struct BrickPast {
  std::vector<std::int32_t> cuts;  // numbers of the sweeps that changed it, ascending
  std::vector<BrickCopy> copies;   // ascending
  bool was_full = false;           // before the first cut

  /// Returns how many of its cuts belong to the first `sweeps` sweeps.
  std::size_t cuts_before(std::size_t sweeps) const;
  /// Returns the last copy made after at most `cuts_made` cuts; nullptr if there is none.
  const BrickCopy* copy_before(std::size_t cuts_made) const;
};

/// The history of all bricks.
struct Past {
  Past(std::size_t bricks, std::size_t most_bytes) : of_brick(bricks), most_copied(most_bytes) {}

  /// When the copies approach the memory limit, doubles the number of cuts between copies and deletes those in between.
  void make_room();
  /// Records a cut. Safe with several threads, as each brick is cut by one thread only.
  ///   after  the brick; nullptr if no material is left
  void add(std::size_t brick, std::int32_t sweep, const Brick* after);
  std::size_t bytes() const;

  std::vector<BrickPast> of_brick;
  std::size_t most_copied;             // limit of the copies in bytes
  std::atomic<std::size_t> copied{0};  // bytes of the copies
  std::size_t apart = 32;              // cuts from one copy to the next
};

std::size_t bytes_of(const Brick& brick);

}  // namespace kadr
