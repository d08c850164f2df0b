#pragma once
// AirLines: pieces of ways at feed, and whether anything was removed on them → lines with the most seconds in the air.
//
// A piece that is shorter than a cell may cut between lattice lines: pieces without a cut count where two cells of path in a row have none.
//
//   law  of no more than `most` lines the seconds are exact; of more each lacks at most what missing() says (tests/session/block_load_test)

#include <map>
#include <utility>
#include <vector>

#include "stock/cut_load.h"

namespace kadr {

class AirLines {
 public:
  static constexpr std::size_t most = 1 << 16;  // lines that are kept: where there are more, the half with fewer seconds goes

  explicit AirLines(double cell, std::size_t most_kept = most) : reach_(2 * cell), most_(most_kept) {}

  struct Piece {
    Origin origin;
    std::uint32_t tool = 0;
    double seconds = 0, length = 0;
    bool cuts = false;
  };
  void add(const Piece& piece);
  /// The most seconds first.
  std::vector<AirCut> emptiest() const;
  /// s that a line may lack.
  double missing() const { return missing_; }

 private:
  using Key = std::pair<std::uint16_t, std::uint32_t>;  // file, line

  void count(const Piece& piece);
  void drop_half();

  double reach_;
  std::size_t most_;
  std::vector<Piece> row_;  // without a cut, together shorter than reach_
  double row_length_ = 0;
  bool in_air_ = false;  // the last reach_ of path has removed nothing
  std::map<Key, AirCut> lines_;
  double missing_ = 0;
};

}  // namespace kadr
