#pragma once
// What a view close up shows of a difference, and from which side. For compare/difference_plot.

#include "out/picture/plot_view.h"

namespace kadr {

struct DifferenceWindow {
  View view = View::xy;
  Box box;
  double finest = 0;    // mm: less is not seen
  bool closer = false;  // it shows more than the whole part does
};

///   differing  where the two differ
///   apart      from a's place to b's where they are the farthest; zero: their places are the same
///   at         there
///   part       all that both do
DifferenceWindow window_of(const Box& differing, Vec3 apart, Vec3 at, const Box& part);

}  // namespace kadr
