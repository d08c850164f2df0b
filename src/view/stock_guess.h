#pragma once
// StockGuess: the blank that a program seems to be written for, by where its path goes at feed. A proposal, to be looked at by a person.

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
  /// Pieces of the path in their order, from the machine's zero.
  void take(const ViewPiece& piece);

  /// mm of a tool by its number; 0: nobody knows it.
  using RadiusOf = std::function<double(std::uint32_t tool)>;

  /// As `--stock` says it: a box around what is cut, with a margin: around the way of the tools' middles, and beyond what they sweep, so
  /// that a pocket has walls; not so far that a tool that comes down beside the blank would come down into it. Round about the axis of a
  /// part that turns. Its top is Z0 where nearly all is cut below that, as zeros are mostly set; else the highest place where the tool goes
  /// sideways at feed. A place below the top to which the tool comes down at rapid is beside the blank: the way in from there, and out to
  /// there, does not count.
  ///   zero     of the picture
  ///   turned   the part spins about X0 Y0
  ///   returns  empty: nothing is cut
  std::string text(Vec3 zero, bool turned, const RadiusOf& radius_of) const;

  /// All of the path at feed lies in one plane with the axis X0 Y0: as a lathe's does, and that of few mills.
  bool is_flat(Vec3 zero) const;

 private:
  struct Level {
    double way = 0;  // mm gone sideways at feed
    double highest = -1e300;
  };
  struct Place {
    Vec3 at;
    std::uint32_t tool = 0;
  };
  using Boxes = std::map<std::uint32_t, Box3>;  // by tool
  /// What is cut by a blank with some top.
  struct Cut {
    Boxes boxes;
    std::vector<Place> beside;  // where tools come down beside it
  };
  static void widen(Boxes& boxes, const Place& place);
  void take_way(Place from, Place to);
  void take_level(Vec3 from, Vec3 to);
  double top_of(double zero) const;
  Cut cut_below(double top) const;

  std::optional<Box3> all_;           // of the path at feed
  Boxes certain_;                     // without the places below
  std::vector<Place> starts_, ends_;  // of ways sideways after a rapid, before a rapid
  std::optional<Place> end_;          // of the last way sideways: what comes after it is not known yet
  bool after_rapid_ = true;
  std::map<int, Level> levels_;  // by height
};

}  // namespace kadr
