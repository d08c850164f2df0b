#pragma once
// SpeedPlan plans the speeds along a path of pieces (NCT 7.0.2). Each piece has its own speed limit. The path starts at a given speed and
// ends at rest.
//
//   limits   ┌─────┐     ┌───        linear: one backward and one forward pass over the speeds of the junctions, each piece with its own │
//            └──┐  │           acceleration (INFERRED algorithm of 7.0.2).
//   speed    │/‾‾‾\___│_/│           bell-shaped: anchors, where the acceleration is zero, are placed at the lowest limits first; /
//            ▲  ▲           between two anchors there is one ramp up and one down over the summed length.
//
// Speeds are in mm/s, lengths in mm and times in s.

#include <cstddef>
#include <span>
#include <vector>

#include "motion/look_ahead/ramp.h"

namespace kadr {

struct PathPiece {
  double length = 0;  // length of the piece, mm, greater than 0
  double most = 0;    // limit: the highest allowed speed in the piece, mm/s, greater than 0
  double enter = 0;   // The highest allowed speed at the start of the piece, mm/s. The limits of the previous piece apply too.
  Acceleration acceleration{};
  // The fields below are results of SpeedPlan::make().
  double seconds = 0;
  double top = 0;  // result: the highest speed in the piece, mm/s
  double end = 0;  // result: the speed at the end of the piece, mm/s
  // True if the speed does not fall at the end of this piece. A separate plan that starts at this end can stop within the remaining path.
  bool steady = true;
};

/// The planner of the speeds of a path. It reuses its allocated memory for the next path.
class SpeedPlan {
 public:
  /// Plans the speeds from the speed `start`, mm/s, to rest at the end of the last piece.
  ///   law  the speed in a piece is at most `most` of this piece; the speed at its end is at most `enter` of the next piece; the change of
  ///        speed in a piece needs no more length than the piece has
  void make(std::span<PathPiece> pieces, double start);

 private:
  void make_linear();
  void make_smooth();
  bool is_anchor_free(std::size_t node) const;
  void place_anchor(std::size_t node);
  void fill(std::size_t first, std::size_t last);
  Acceleration gentlest(std::size_t first, std::size_t last) const;
  Acceleration liveliest(std::size_t first, std::size_t last) const;
  double distance(std::size_t first, std::size_t last) const { return at_[last] - at_[first]; }

  std::span<PathPiece> pieces_;
  // Speed at each node, mm/s. A node is a joint of two pieces or an end of the path. The value is first the speed limit, and after the
  // planning the planned speed.
  std::vector<double> speed_;
  std::vector<double> at_;  // path length from the start to each node, mm
  std::vector<bool> anchor_;
  std::vector<std::size_t> order_;
};

}  // namespace kadr
