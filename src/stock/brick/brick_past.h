#pragma once
// BrickPast: what a brick has been through, so that it can be shown as it was at any sweep.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "stock/brick/brick.h"

namespace kadr {

/// The brick as it was after so many of its cuts.
struct BrickCopy {
  std::size_t cuts;
  std::unique_ptr<Brick> brick;
};

struct BrickPast {
  std::vector<std::int32_t> cuts;  // numbers of the sweeps that changed it, ascending
  std::vector<BrickCopy> copies;   // ascending
  bool was_full = false;           // before the first

  /// How many of its cuts are among the first `sweeps` sweeps.
  std::size_t cuts_before(std::size_t sweeps) const;
  /// The last copy that lies no later; nullptr: there is none.
  const BrickCopy* copy_before(std::size_t cuts_made) const;
};

/// Of all bricks.
struct Past {
  Past(std::size_t bricks, std::size_t most_bytes) : of_brick(bricks), most_copied(most_bytes) {}

  /// Where copies have come close to what they may hold, they are put twice as far apart, and those that lie between given up.
  void make_room();
  /// A brick is the work of one thread, and so is its past.
  ///   after  the brick; nullptr: nothing is left of it
  void add(std::size_t brick, std::int32_t sweep, const Brick* after);
  std::size_t bytes() const;

  std::vector<BrickPast> of_brick;
  std::size_t most_copied;             // bytes of copies
  std::atomic<std::size_t> copied{0};  // bytes
  std::size_t apart = 32;              // cuts from one copy to the next
};

std::size_t bytes_of(const Brick& brick);

}  // namespace kadr
