#pragma once
// Selects the area of the part that a close-up picture of a difference shows, and the direction of view. Used by compare/difference_plot.

#include "out/picture/plot/plot_view.h"

namespace kadr {

struct DifferenceWindow {
  View view = View::xy;
  Box box;
  double finest = 0;    // size of the smallest details that are visible in the close-up, mm
  bool closer = false;  // true if the close-up shows more detail than the view of the whole part
};

///   differing  box of the paths that differ
///   apart      vector from the position of a to that of b where the paths are farthest apart; zero if both positions are equal
///   at         position of b where the paths are farthest apart
///   part       box of the path that both follow
DifferenceWindow window_of(const Box& differing, Vec3 apart, Vec3 at, const Box& part);

}  // namespace kadr
