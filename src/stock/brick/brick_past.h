#pragma once
// BrickPast: the history of a brick, from which the state of the brick before any given sweep can be restored.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "stock/brick/brick.h"

namespace kadr {

/// State of a brick after the first `cuts` cuts.
struct BrickCopy {
  std::size_t cuts;
  std::unique_ptr<Brick> brick;
};

struct BrickPast {
  std::vector<std::int32_t> cuts;  // numbers of the sweeps that changed the brick, in ascending order
  std::vector<BrickCopy> copies;   // copies of the brick in ascending order of `cuts`
  bool was_full = false;           // true if the brick was full of material before the first cut

  /// Returns how many of the brick's cuts belong to the first `sweeps` sweeps of the stock.
  std::size_t cuts_before(std::size_t sweeps) const;
  /// Returns the latest copy that was made after at most `cuts_made` cuts of the brick; nullptr if no copy was made so early.
  const BrickCopy* copy_before(std::size_t cuts_made) const;
};

/// The history of all bricks of a stock.
struct Past {
  Past(std::size_t bricks, std::size_t max_bytes) : of_brick(bricks), most_copied(max_bytes) {}

  /// Must be called regularly. When the copies approach the memory limit, this function doubles the number of cuts between two copies of a
  /// brick, and deletes the copies in between.
  void make_room();
  /// Records that a sweep cut a brick. Several threads may call this function at once, since each brick is cut by one thread only.
  ///   after  the state of the brick that the sweep has left; nullptr if no material remains
  void add(std::size_t brick, std::int32_t sweep, const Brick* after);
  std::size_t bytes() const;

  std::vector<BrickPast> of_brick;
  std::size_t most_copied;             // greatest memory for the copies of bricks, bytes
  std::atomic<std::size_t> copied{0};  // memory that the copies of bricks need at present, bytes
  std::size_t apart = 32;              // number of cuts from one copy of a brick to the next
};

std::size_t bytes_of(const Brick& brick);

}  // namespace kadr
