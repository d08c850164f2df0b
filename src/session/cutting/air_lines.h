#pragma once
// AirLines: finds the lines that spend the most time moving at feed in the air. Its input is the motions at feed, divided into segments.
// For each segment the caller states whether it removed material.
//
// A segment shorter than a cell may pass between two lattice lines and miss the material. Therefore a segment counts as air only if
// consecutive segments of at least two cells of path removed nothing.
//
//   law  up to `most` lines the seconds are exact; with more lines, each may have up to missing() s too few (tests/session/block_load_test)

#include <map>
#include <utility>
#include <vector>

#include "stock/cut_load.h"

namespace kadr {

class AirLines {
 public:
  // Greatest number of lines whose times are stored. When it is exceeded, the half of the lines with the shorter times is dropped.
  static constexpr std::size_t most = 1 << 16;

  explicit AirLines(double cell, std::size_t max_kept = most) : reach_(2 * cell), most_(max_kept) {}

  struct Piece {
    Origin origin;
    std::uint32_t tool = 0;
    double seconds = 0, length = 0;
    bool cuts = false;
  };
  void add(const Piece& piece);
  /// Returns the lines that spend time in the air, in descending order of that time.
  std::vector<AirCut> emptiest() const;
  /// Returns the greatest error of the times that emptiest() returns, s. Each line may have spent up to this much more time in the air than
  /// reported.
  double missing() const { return missing_; }

 private:
  using Key = std::pair<std::uint16_t, std::uint32_t>;  // file number (Origin::file) and line number

  void count(const Piece& piece);
  void drop_half();

  double reach_;
  std::size_t most_;
  // The latest consecutive segments that removed nothing. They do not count as air yet, since their path together is shorter than reach_.
  std::vector<Piece> row_;
  double row_length_ = 0;
  // true: the last reach_ mm of the path have removed nothing, so a further segment that removes nothing counts as air at once
  bool in_air_ = false;
  std::map<Key, AirCut> lines_;
  double missing_ = 0;
};

}  // namespace kadr
