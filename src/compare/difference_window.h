#pragma once
// Selects what a close-up shows of a difference, and from which side. Used by compare/difference_plot.

#include "out/picture/plot_view.h"

namespace kadr {

struct DifferenceWindow {
  View view = View::xy;
  Box box;
  double finest = 0;    // mm: smaller details are not visible
  bool closer = false;  // it shows more detail than the view of the whole part
};

///   differing  box of what differs
///   apart      vector from a's to b's position where they are farthest apart; zero: the positions are equal
///   at         that position
///   part       box of all that both do
DifferenceWindow window_of(const Box& differing, Vec3 apart, Vec3 at, const Box& part);

}  // namespace kadr
