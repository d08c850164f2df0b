#pragma once
// BlockLoads: motions at feed with what they took away → a row a block, the heaviest lines.
//
// What a way shorter than a cell takes away is counted by whole lattice lines. So short blocks in a row share: rate, feed and engagement
// are a mean over at least two cells of path, and the volume of all of them is divided by their lengths; its sum stays exact.
//
//   law  the rows come in the order of the program; their volumes are those of the motions, in sum   (tests/session/block_load_test)

#include <functional>
#include <vector>

#include "stock/cut_load.h"

namespace kadr {

/// A motion at feed, cut.
struct CutMotion {
  Origin origin;
  std::uint32_t tool = 0;
  double diameter = 0;  // of the tool
  double teeth = 0;     // that pass in a second; 0: not known
  double begins = 0, seconds = 0;
  double length = 0, flat = 0;  // of its way, and of that in the plane
  double volume = 0, depth = 0;
  std::size_t first_sweep = 0, end_sweep = 0;
  Vec3 at;  // the middle of its way
};

class BlockLoads {
 public:
  explicit BlockLoads(double cell) : reach_(2 * cell) {}

  /// Called with each row.
  std::function<void(const BlockLoad&)> on_block;
  /// Called with sweeps of the stock, from `first` up to before `end`, and their removal rate, mm³/s.
  std::function<void(std::size_t first, std::size_t end, double rate)> on_rate;

  void add(const CutMotion& motion);
  /// Nothing follows.
  void finish();
  /// Lines with the greatest removal rate, the greatest first; of each line the time when it took most.
  std::vector<BlockLoad> heaviest() const;

 private:
  /// Of motions: of a block, of blocks in a row.
  struct Sum {
    double seconds = 0, length = 0, flat = 0, volume = 0, depth = 0;
    void add(const Sum& more);
  };
  struct Block {
    CutMotion first;
    Sum sum;
    std::size_t end_sweep = 0;
  };
  static constexpr std::size_t most_in_row = 1 << 16;  // short blocks that share

  void end_block();
  void end_row();
  void tell(const std::vector<Block>& row);
  void weigh(const BlockLoad& row);

  double reach_;              // mm of path over which a mean is told
  std::vector<Block> open_;   // the block that goes on, if any
  std::vector<Block> short_;  // in a row, all together shorter than reach_
  std::vector<BlockLoad> heaviest_;
};

}  // namespace kadr
