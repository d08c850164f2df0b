#pragma once
// StockGuess: proposes the blank for which a program was probably written. The proposal is based on the path that the program travels at
// feed. The user must check the proposal.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "session/cutting/stated_box.h"
#include "session/cutting/turning/stated_blank.h"
#include "stock/brick/lattice.h"
#include "view/path_piece.h"

namespace kadr {

/// What else than the path tells the blank.
struct BlankHints {
  TurnedHints turned;            // of a part that rotates
  std::optional<StatedBox> box;  // of a milled part: the size that a comment states
};

class StockGuess {
 public:
  /// Adds a segment of the path. The segments must be added in order, with positions relative to the machine's zero point.
  void take(const ViewPiece& piece);

  /// A function that returns the radius in mm of the tool with a given number; 0 if the radius is unknown.
  using RadiusOf = std::function<double(std::uint32_t tool)>;

  /// Returns the blank as a text for `--stock`. For milling, the blank is a box around the material that is cut, with a margin. The box
  /// contains more than the area that the tools sweep, so that a pocket has walls. But a tool that descends outside the blank does not
  /// touch the box. For turning, the blank is a cylinder about the axis.
  ///
  /// The top of the blank is Z0 if nearly everything is cut below Z0, because most programs have their zero at the top. Otherwise the top
  /// is the highest level at which the tool moves sideways at feed. A point below the top to which the tool descends at rapid is outside
  /// the blank; the paths from this point to the part, and back, are not counted as cutting.
  ///   zero     zero point of the picture
  ///   turned   true if the part rotates about X0 Y0
  ///   hints    what comments and set-up tell; a stated box has its size from there, and its place from the path
  ///   returns  the blank; an empty text if nothing is cut
  std::string text(Vec3 zero, bool turned, const RadiusOf& radius_of, const BlankHints& hints = {}) const;

  /// Returns true if the whole path at feed is in one plane through the axis X0 Y0, as is usual on a lathe and rare on a mill.
  bool is_flat(Vec3 zero) const;

 private:
  struct Level {
    double path_length = 0;  // length in mm of the path that the tool moves sideways at feed on this level
    double highest = -1e300;
  };
  struct Place {
    Vec3 at;
    std::uint32_t tool = 0;
  };
  using Boxes = std::map<std::uint32_t, Box3>;  // one box for each tool; the key is the number of the tool
  /// The material that the program cuts if the blank has a certain top.
  struct Cut {
    Boxes boxes;
    std::vector<Place> outside;  // positions of tools that descend outside the blank
  };
  static void widen(Boxes& boxes, const Place& place);
  void take_path(Place from, Place to);
  void take_level(Vec3 from, Vec3 to);
  double top_of(double zero) const;
  Cut cut_below(double top) const;

  std::optional<Box3> all_;  // box around the path at feed
  // Boxes around the path at feed, without the positions in starts_ and ends_, where sideways travel starts after a rapid or ends before a
  // rapid.
  Boxes certain_;
  std::vector<Place> starts_, ends_;  // positions where sideways travel starts after a rapid, and where sideways travel ends before a rapid
  std::optional<Place> end_;          // end of the last sideways travel, until the next motion is known
  bool after_rapid_ = true;
  std::map<int, Level> levels_;  // levels of the path; the key is the number of the level, counted from the height 0
};

}  // namespace kadr
