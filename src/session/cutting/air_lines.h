#pragma once
// AirLines: finds the lines that spend the most time moving at feed in the air. The input is the motions at feed, divided into pieces; for
// each piece the caller states whether it removed material.
//
// A piece shorter than a cell may pass between two lattice lines and miss the material. Therefore a piece counts as air only if at least
// two cells of path in succession removed nothing.
//
//   law  up to `most` lines the seconds are exact; with more lines, each may have up to missing() s too few (tests/session/block_load_test)

#include <map>
#include <utility>
#include <vector>

#include "stock/cut_load.h"

namespace kadr {

class AirLines {
 public:
  static constexpr std::size_t most = 1 << 16;  // number of lines stored; when there are more, the half with fewer seconds is dropped

  explicit AirLines(double cell, std::size_t max_kept = most) : reach_(2 * cell), most_(max_kept) {}

  struct Piece {
    Origin origin;
    std::uint32_t tool = 0;
    double seconds = 0, length = 0;
    bool cuts = false;
  };
  void add(const Piece& piece);
  /// The lines that spend time in the air, in descending order of their seconds in the air.
  std::vector<AirCut> emptiest() const;
  /// Greatest error of the times: the time of a line may be too short by this many s.
  double missing() const { return missing_; }

 private:
  using Key = std::pair<std::uint16_t, std::uint32_t>;  // Origin::file, line

  void count(const Piece& piece);
  void drop_half();

  double reach_;
  std::size_t most_;
  // the latest pieces that removed nothing, which do not count as air yet, since together they are shorter than reach_
  std::vector<Piece> row_;
  double row_length_ = 0;
  bool in_air_ = false;  // the last reach_ mm of the path have removed nothing
  std::map<Key, AirCut> lines_;
  double missing_ = 0;
};

}  // namespace kadr
