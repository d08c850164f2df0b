#pragma once
// StockGuess: proposes the blank for which a program seems to be written. It uses the path that the program moves at feed. A person must
// check the proposal.

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
  /// Adds a piece of the path. The pieces must come in order, with positions relative to the machine's zero point.
  void take(const ViewPiece& piece);

  /// Returns the radius of a tool by its number, mm; 0: unknown.
  using RadiusOf = std::function<double(std::uint32_t tool)>;

  /// Returns the blank as a text for `--stock`. For milling it is a box around what is cut, with a margin. The box contains more than the
  /// area that the tools sweep, so that a pocket has walls. But a tool that descends outside the blank does not touch the box. For turning,
  /// the blank is a cylinder about the axis.
  ///
  /// The top of the blank is Z0 if nearly everything is cut below Z0, since most programs have their zero there. Otherwise it is the
  /// highest level at which the tool moves sideways at feed. A point below the top to which the tool descends at rapid is outside the
  /// blank; the paths from that point to the part, and back, are not counted as cutting.
  ///   zero     zero point of the picture
  ///   turned   true: the part rotates about X0 Y0
  ///   returns  an empty text if nothing is cut
  std::string text(Vec3 zero, bool turned, const RadiusOf& radius_of) const;

  /// True if the whole path at feed is in one plane through the axis X0 Y0, as on a lathe and rarely on a mill.
  bool is_flat(Vec3 zero) const;

 private:
  struct Level {
    double way = 0;  // length of the path that moves sideways at feed on this level, mm
    double highest = -1e300;
  };
  struct Place {
    Vec3 at;
    std::uint32_t tool = 0;
  };
  using Boxes = std::map<std::uint32_t, Box3>;  // a box for each tool number
  /// What is cut if the blank has a certain top.
  struct Cut {
    Boxes boxes;
    std::vector<Place> beside;  // positions where tools descend outside the blank
  };
  static void widen(Boxes& boxes, const Place& place);
  void take_way(Place from, Place to);
  void take_level(Vec3 from, Vec3 to);
  double top_of(double zero) const;
  Cut cut_below(double top) const;

  std::optional<Box3> all_;           // box around the path at feed
  Boxes certain_;                     // boxes around the path at feed, without the ends in starts_ and ends_
  std::vector<Place> starts_, ends_;  // starts of sideways travel after a rapid; ends of sideways travel before a rapid
  std::optional<Place> end_;          // end of the last sideways travel, until the next motion is known
  bool after_rapid_ = true;
  std::map<int, Level> levels_;  // by height
};

}  // namespace kadr
