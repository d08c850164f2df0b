#pragma once
// AirLines: finds the lines whose moves at feed spend most time in the air. The input is pieces of moves at feed, each with whether it
// removed anything.
//
// A piece shorter than a cell may cut between lattice lines, so it counts as air only if at least two cells of path in a row are without
// a cut.
//
//   law  with at most `most` lines the seconds are exact; with more, each line lacks at most missing() (tests/session/block_load_test)

#include <map>
#include <utility>
#include <vector>

#include "stock/cut_load.h"

namespace kadr {

class AirLines {
 public:
  static constexpr std::size_t most = 1 << 16;  // lines kept; beyond this number, the half with fewer seconds is dropped

  explicit AirLines(double cell, std::size_t most_kept = most) : reach_(2 * cell), most_(most_kept) {}

  struct Piece {
    Origin origin;
    std::uint32_t tool = 0;
    double seconds = 0, length = 0;
    bool cuts = false;
  };
  void add(const Piece& piece);
  /// Sorted by seconds, the most first.
  std::vector<AirCut> emptiest() const;
  /// s that a line may lack at most.
  double missing() const { return missing_; }

 private:
  using Key = std::pair<std::uint16_t, std::uint32_t>;  // file, line

  void count(const Piece& piece);
  void drop_half();

  double reach_;
  std::size_t most_;
  std::vector<Piece> row_;  // recent pieces without a cut, shorter than reach_ in total
  double row_length_ = 0;
  bool in_air_ = false;  // the last reach_ of the path has removed nothing
  std::map<Key, AirCut> lines_;
  double missing_ = 0;
};

}  // namespace kadr
