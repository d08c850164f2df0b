#pragma once
// BlockLoads: sums up the motions at feed and the volumes that they removed, and returns one table row of results per block. It also finds
// the lines with the highest removal rate.
//
// On a path shorter than a cell, the removed volume is inexact, since it is counted in whole lattice lines. Therefore successive short
// blocks get common values: removal rate, feed and engagement are means over at least two cells of path. The volume is divided in
// proportion to the lengths, so the sum of the volumes remains exact.
//
//   law  the results come in the order of the program, and the sum of their volumes is that of the motions (tests/session/block_load_test)

#include <functional>
#include <vector>

#include "stock/cut_load.h"

namespace kadr {

/// A motion at feed and the material that it has removed.
struct CutMotion {
  Origin origin;
  std::uint32_t tool = 0;
  double diameter = 0;  // diameter of the tool, mm
  double teeth = 0;     // number of teeth that pass a point of the material per second; 0: unknown
  double begins = 0, seconds = 0;
  double length = 0, flat = 0;  // length of the path, and length of its projection onto the working plane, mm
  double volume = 0, depth = 0;
  std::size_t first_sweep = 0, end_sweep = 0;
  Vec3 at;  // middle of the path, mm from the zero point of the work coordinates
};

class BlockLoads {
 public:
  explicit BlockLoads(double cell) : reach_(2 * cell) {}

  /// A function of the caller that receives the table row of each block, with the results of the block.
  std::function<void(const BlockLoad&)> on_block;
  /// A function of the caller that receives a removal rate, mm³/s, and the sweeps of the stock that have this rate: those with numbers from
  /// `first` up to, but excluding, `end`.
  std::function<void(std::size_t first, std::size_t end, double rate)> on_rate;

  void add(const CutMotion& motion);
  /// Declares that no motion follows, so that the last blocks are reported.
  void finish();
  /// Returns the lines with the highest removal rate, in descending order. Each line has the time at which its rate was highest.
  std::vector<BlockLoad> heaviest() const;

 private:
  /// Totals of the motions of one block or of several successive blocks.
  struct Sum {
    double seconds = 0, length = 0, flat = 0, volume = 0, depth = 0;
    void add(const Sum& more);
  };
  struct Block {
    CutMotion first;
    Sum sum;
    std::size_t end_sweep = 0;
  };
  static constexpr std::size_t most_in_row = 1 << 16;  // greatest number of successive short blocks that get common values

  void end_block();
  void end_row();
  void report_row(const std::vector<Block>& row);
  void weigh(const BlockLoad& row);

  double reach_;              // length of path over which mean values are computed, mm
  std::vector<Block> open_;   // the current block as the only element; empty: no motion has come yet
  std::vector<Block> short_;  // successive short blocks, which are together shorter than reach_
  std::vector<BlockLoad> heaviest_;
};

}  // namespace kadr
