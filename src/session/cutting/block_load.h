#pragma once
// BlockLoads: turns motions at feed and their removed volumes into one row per block, and finds the most loaded lines.
//
// What a path shorter than a cell removes is counted in whole lattice lines. Therefore short blocks in a row share their values: rate,
// feed and engagement are means over at least two cells of path, and the total volume is divided in proportion to length; the sum of
// volumes stays exact.
//
//   law  the rows come in the order of the program; the sum of their volumes is that of the motions   (tests/session/block_load_test)

#include <functional>
#include <vector>

#include "stock/cut_load.h"

namespace kadr {

/// A motion at feed that has been cut.
struct CutMotion {
  Origin origin;
  std::uint32_t tool = 0;
  double diameter = 0;  // of the tool
  double teeth = 0;     // per second; 0: unknown
  double begins = 0, seconds = 0;
  double length = 0, flat = 0;  // of its path, and of the path's projection onto the plane
  double volume = 0, depth = 0;
  std::size_t first_sweep = 0, end_sweep = 0;
  Vec3 at;  // the middle of its path
};

class BlockLoads {
 public:
  explicit BlockLoads(double cell) : reach_(2 * cell) {}

  /// Receives each row.
  std::function<void(const BlockLoad&)> on_block;
  /// Receives a range of sweeps of the stock, from `first` to before `end`, and their removal rate, mm³/s.
  std::function<void(std::size_t first, std::size_t end, double rate)> on_rate;

  void add(const CutMotion& motion);
  /// States that nothing follows.
  void finish();
  /// Lines with the highest removal rate, the highest first; each line with the time at which its rate was highest.
  std::vector<BlockLoad> heaviest() const;

 private:
  /// Totals over motions: of one block, or of several in a row.
  struct Sum {
    double seconds = 0, length = 0, flat = 0, volume = 0, depth = 0;
    void add(const Sum& more);
  };
  struct Block {
    CutMotion first;
    Sum sum;
    std::size_t end_sweep = 0;
  };
  static constexpr std::size_t most_in_row = 1 << 16;  // limit of short blocks that share their values

  void end_block();
  void end_row();
  void tell(const std::vector<Block>& row);
  void weigh(const BlockLoad& row);

  double reach_;              // mm of path over which a mean is reported
  std::vector<Block> open_;   // the current block, if any
  std::vector<Block> short_;  // short blocks in a row, shorter than reach_ in total
  std::vector<BlockLoad> heaviest_;
};

}  // namespace kadr
