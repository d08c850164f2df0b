#pragma once
// BlockLoads: sums up the motions at feed and the volumes they removed to one row of results per block, and finds the lines with the
// highest removal rate.
//
// On a path shorter than a cell, the removed volume is counted in whole lattice lines and is inexact. Therefore successive short blocks
// share their values: removal rate, feed and engagement are means over at least two cells of path, and the volume is divided in
// proportion to the lengths. The sum of the volumes remains exact.
//
//   law  rows come in the order of the program; the sum of their volumes is that of the motions   (tests/session/block_load_test)

#include <functional>
#include <vector>

#include "stock/cut_load.h"

namespace kadr {

/// A motion at feed whose material has been removed.
struct CutMotion {
  Origin origin;
  std::uint32_t tool = 0;
  double diameter = 0;  // diameter of the tool, mm
  double teeth = 0;     // teeth that pass a point of the material per second; 0: unknown
  double begins = 0, seconds = 0;
  double length = 0, flat = 0;  // length of the path; length of its projection onto the working plane, mm
  double volume = 0, depth = 0;
  std::size_t first_sweep = 0, end_sweep = 0;
  Vec3 at;  // the middle of the path
};

class BlockLoads {
 public:
  explicit BlockLoads(double cell) : reach_(2 * cell) {}

  /// Receives the row of results of each block.
  std::function<void(const BlockLoad&)> on_block;
  /// Receives a range of sweeps of the stock (from `first` up to but excluding `end`) and their removal rate, mm³/s.
  std::function<void(std::size_t first, std::size_t end, double rate)> on_rate;

  void add(const CutMotion& motion);
  /// Declares that no motion follows.
  void finish();
  /// The lines with the highest removal rate, in descending order; each with the time at which its rate was highest.
  std::vector<BlockLoad> heaviest() const;

 private:
  /// Totals of the motions of one block, or of several successive blocks.
  struct Sum {
    double seconds = 0, length = 0, flat = 0, volume = 0, depth = 0;
    void add(const Sum& more);
  };
  struct Block {
    CutMotion first;
    Sum sum;
    std::size_t end_sweep = 0;
  };
  static constexpr std::size_t most_in_row = 1 << 16;  // number of successive short blocks that share their values, at most

  void end_block();
  void end_row();
  void tell(const std::vector<Block>& row);
  void weigh(const BlockLoad& row);

  double reach_;              // mm of path over which mean values are computed
  std::vector<Block> open_;   // the current block; empty: none
  std::vector<Block> short_;  // successive short blocks; together they are shorter than reach_
  std::vector<BlockLoad> heaviest_;
};

}  // namespace kadr
