#pragma once
// Draws the paths of two programs into one view, with the numbers of their differences.

#include "out/picture/plot/plot_view.h"

namespace kadr {

/// The number of a difference and its position in the picture.
struct PlotNumber {
  std::size_t number = 1;
  Vec3 at;
  bool stands = false;  // true: the difference is between two motions, while the axes are stopped
};

struct PlotDifferences {
  const PlotPath& changed;  // path that both programs follow, but with different feeds, tools or other modes
  const PlotPath &a, &b;    // paths that only program a, or only program b, follows
  std::vector<PlotNumber> numbers;
};

struct PathStyle {
  Colour ink;
  double width;
};
/// Colours from the palette of Okabe and Ito, which colour-blind people can distinguish. Where the paths of a and b coincide, the wider
/// line is visible on both sides of the narrower line.
inline constexpr PathStyle same_path{colour(0x8D98A5), 1}, changed_path{colour(0xF0C93A, 0.6), 9}, path_of_a{colour(0x0072B2), 3.4},
    path_of_b{colour(0xD55E00), 1.5};
inline constexpr Colour number_ink = colour(0x20262E);

/// Draws each number next to its position, so that no numbers overlap. A number for which there is no free space is omitted.
void draw_numbers(Canvas& canvas, View view, const ViewScale& scale, const PlotScene& scene, const Area& field);

}  // namespace kadr
