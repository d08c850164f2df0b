#pragma once
// Plans the speeds along a path of pieces, each with a speed limit; the path starts at a given speed and ends at rest. NCT 7.0.2.
//
//   limits   ┌─────┐     ┌───        linear: one backward and one forward pass over the speeds of the junctions, each piece with its own
//            │     └──┐  │           acceleration (INFERRED algorithm of 7.0.2).
//   speed    │/‾‾‾\___│_/│           bell-shaped: anchors, where the acceleration is zero, are placed at the lowest limits first;
//            /        ▲  ▲           between two anchors there is one ramp up and one down over the summed length.
//
// Speeds mm/s, lengths mm, times s.

#include <cstddef>
#include <span>
#include <vector>

#include "motion/look_ahead/ramp.h"

namespace kadr {

struct PathPiece {
  double length = 0;  // length of the piece, above 0
  double most = 0;    // limit: the highest speed allowed in the piece, above 0
  double enter = 0;   // the highest speed at its start; the limits of the previous piece apply in addition
  Acceleration acceleration{};
  // results
  double seconds = 0;
  double top = 0;      // result: the highest speed in the piece
  double end = 0;      // result: the speed at the end of the piece
  bool steady = true;  // the speed does not fall at the end of this piece, so a plan that starts there can stop within the remaining path
};

/// Computes the plan. Reuses its allocated memory from one plan to the next.
class SpeedPlan {
 public:
  /// Plans from the speed `start` to rest at the end of the last piece.
  ///   law  top ≤ most; end ≤ enter of the next piece; the change of speed in a piece needs no more than the length of the piece
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
  // at each node (a joint of two pieces, or an end of the path): at first the limit, at the end the planned speed
  std::vector<double> speed_;
  std::vector<double> at_;  // path length up to each node
  std::vector<bool> anchor_;
  std::vector<std::size_t> order_;
};

}  // namespace kadr
