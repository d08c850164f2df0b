#pragma once
// Two programs in one view: what is drawn beside the path that both go, and the numbers of the differences.

#include "out/picture/plot_view.h"

namespace kadr {

/// The number of a difference at its place.
struct PlotNumber {
  std::size_t number = 1;
  Vec3 at;
  bool stands = false;  // the axes stand there: what differs is done between motions
};

struct PlotDifferences {
  const PlotPath& changed;  // both go it, with another feed, tool …
  const PlotPath &a, &b;    // that only one of them goes
  std::vector<PlotNumber> numbers;
};

struct WayStyle {
  Colour ink;
  double width;
};
/// Okabe and Ito's colours; where both lie upon each other the wider shows on either side.
inline constexpr WayStyle same_way{colour(0x8D98A5), 1}, changed_way{colour(0xF0C93A, 0.6), 9}, way_of_a{colour(0x0072B2), 3.4},
    way_of_b{colour(0xD55E00), 1.5};
inline constexpr Colour number_ink = colour(0x20262E);

/// Beside their places, none over another; those that find no room are left out.
void draw_numbers(Canvas& canvas, View view, const ViewScale& scale, const PlotScene& scene, const Area& field);

}  // namespace kadr
