#pragma once
// StockGuess: proposes the blank that a program seems to be written for, from its path at feed. A person must check the proposal.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "stock/brick/lattice.h"
#include "view/path_piece.h"

namespace kadr {

class StockGuess {
 public:
  /// Takes the pieces of the path in order, relative to the machine's zero.
  void take(const ViewPiece& piece);

  /// Radius of a tool by its number, mm; 0: unknown.
  using RadiusOf = std::function<double(std::uint32_t tool)>;

  /// The blank as a text for `--stock`: a box around what is cut, with a margin. The box contains the path of the tool centres and
  /// exceeds what they sweep, so that a pocket has walls, but not so far that a tool that moves down outside the blank would enter it.
  /// For a part that rotates it is round about the axis. The top is Z0 if nearly everything is cut below Z0, as zeros are mostly set;
  /// else the highest level at which the tool moves sideways at feed. A point below the top to which the tool moves down at rapid is
  /// outside the blank: the path in from there, and out to there, does not count.
  ///   zero     of the picture
  ///   turned   the part rotates about X0 Y0
  ///   returns  empty if nothing is cut
  std::string text(Vec3 zero, bool turned, const RadiusOf& radius_of) const;

  /// True if the whole path at feed is in one plane through the axis X0 Y0, as on a lathe and on few mills.
  bool is_flat(Vec3 zero) const;

 private:
  struct Level {
    double way = 0;  // mm of travel sideways at feed
    double highest = -1e300;
  };
  struct Place {
    Vec3 at;
    std::uint32_t tool = 0;
  };
  using Boxes = std::map<std::uint32_t, Box3>;  // by tool
  /// What is cut, for a given top of the blank.
  struct Cut {
    Boxes boxes;
    std::vector<Place> beside;  // where tools move down outside the blank
  };
  static void widen(Boxes& boxes, const Place& place);
  void take_way(Place from, Place to);
  void take_level(Vec3 from, Vec3 to);
  double top_of(double zero) const;
  Cut cut_below(double top) const;

  std::optional<Box3> all_;           // around the path at feed
  Boxes certain_;                     // without the points in starts_ and ends_
  std::vector<Place> starts_, ends_;  // of sideways travel after a rapid, and before a rapid
  std::optional<Place> end_;          // end of the last sideways travel: the next motion is not known yet
  bool after_rapid_ = true;
  std::map<int, Level> levels_;  // key: height
};

}  // namespace kadr
