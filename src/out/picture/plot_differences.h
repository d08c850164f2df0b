#pragma once
// Draws two programs in one view: the paths that differ, and the numbers of the differences.

#include "out/picture/plot_view.h"

namespace kadr {

/// The number of a difference and its position.
struct PlotNumber {
  std::size_t number = 1;
  Vec3 at;
  bool stands = false;  // the axes are at rest there: the difference is between motions
};

struct PlotDifferences {
  const PlotPath& changed;  // both follow it, but with another feed, tool …
  const PlotPath &a, &b;    // paths that only one of them follows
  std::vector<PlotNumber> numbers;
};

struct WayStyle {
  Colour ink;
  double width;
};
/// Okabe and Ito's colours. Where both paths coincide, the wider one shows on either side of the other.
inline constexpr WayStyle same_way{colour(0x8D98A5), 1}, changed_way{colour(0xF0C93A, 0.6), 9}, way_of_a{colour(0x0072B2), 3.4},
    way_of_b{colour(0xD55E00), 1.5};
inline constexpr Colour number_ink = colour(0x20262E);

/// Draws the numbers next to their positions without overlap; a number that finds no room is left out.
void draw_numbers(Canvas& canvas, View view, const ViewScale& scale, const PlotScene& scene, const Area& field);

}  // namespace kadr
