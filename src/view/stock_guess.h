#pragma once
// StockGuess: the blank that a program seems to be written for, by where its path goes at feed. A proposal, to be looked at by a person.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "stock/brick/lattice.h"
#include "view/path_piece.h"

namespace kadr {

class StockGuess {
 public:
  /// Pieces of the path in their order, from the machine's zero.
  void take(const ViewPiece& piece);

  /// As `--stock` says it: a box around what is cut, with a margin; round about the axis of a part that turns. Its top is Z0 where nearly
  /// all is cut below that, as zeros are mostly set; else the highest place where the tool goes sideways at feed. A place below the top to
  /// which the tool comes down at rapid is beside the blank: the way in from there, and out to there, does not count.
  ///   zero     of the picture
  ///   turned   the part spins about X0 Y0
  ///   returns  empty: nothing is cut
  std::string text(Vec3 zero, bool turned) const;

  /// All of the path at feed lies in one plane with the axis X0 Y0: as a lathe's does, and that of few mills.
  bool is_flat(Vec3 zero) const;

 private:
  struct Level {
    double way = 0;  // mm gone sideways at feed
    double highest = -1e300;
  };
  void take_way(Vec3 from, Vec3 to);
  void take_level(Vec3 from, Vec3 to);
  double top_of(double zero) const;
  Box3 cut_below(double top) const;

  std::optional<Box3> all_;          // of the path at feed
  std::optional<Box3> certain_;      // without the places below
  std::vector<Vec3> starts_, ends_;  // of ways sideways after a rapid, before a rapid
  std::optional<Vec3> end_;          // of the last way sideways: what comes after it is not known yet
  bool after_rapid_ = true;
  std::map<int, Level> levels_;  // by height
};

}  // namespace kadr
