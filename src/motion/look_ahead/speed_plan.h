#pragma once
// The speeds along a path of pieces, each with a limit, from a given speed to rest. NCT 7.0.2.
//
//   limits   ┌─────┐     ┌───        linear: the speeds of the junctions by a pass backward and one forward, each piece with its own
//            │     └──┐  │           acceleration (INFERRED algorithm of 7.0.2).
//   speed    │/‾‾‾\___│_/│           bell-shaped: anchors, where the acceleration is zero, at the lowest limits first; between two of
//            /        ▲  ▲           them one ramp up and one down over the summed length.
//
// Speeds mm/s, lengths mm, times s.

#include <cstddef>
#include <span>
#include <vector>

#include "motion/look_ahead/ramp.h"

namespace kadr {

struct PathPiece {
  double length = 0;  // above 0
  double most = 0;    // its highest speed, above 0
  double enter = 0;   // the highest speed at which it may begin, that of the piece before aside
  Acceleration acceleration{};
  // what comes out
  double seconds = 0;
  double top = 0;      // the highest speed in it
  double end = 0;      // the speed at its end
  bool steady = true;  // the path does not slow down there: a plan that begins there comes to rest within the rest of the path
};

/// Plans; it keeps its memory from one plan to the next.
class SpeedPlan {
 public:
  /// From `start` to rest at the end of the last piece.
  ///   law  top ≤ most; end ≤ enter of the next; the change of speed in a piece needs no more than its length
  void make(std::span<PathPiece> pieces, double start);

 private:
  void make_linear();
  void make_smooth();
  bool is_anchor_free(std::size_t node) const;
  void place_anchor(std::size_t node);
  void fill(std::size_t first, std::size_t last);
  Acceleration gentlest(std::size_t first, std::size_t last) const;
  Acceleration liveliest(std::size_t first, std::size_t last) const;
  double way(std::size_t first, std::size_t last) const { return at_[last] - at_[first]; }

  std::span<PathPiece> pieces_;
  std::vector<double> speed_;  // of each node, between two pieces and at both ends: the limit, in the end the planned one
  std::vector<double> at_;     // way up to the node
  std::vector<bool> anchor_;
  std::vector<std::size_t> order_;
};

}  // namespace kadr
