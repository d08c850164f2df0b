#pragma once
// The page of a plot: title, the isometric view large on the left, the planes on the right, legend below.

#include <string>
#include <vector>

#include "out/plot.h"

namespace kadr {

struct PlotScene {
  const PlotPath& path;
  const PlotPath& contour;  // as programmed, where the tool runs beside it; may be empty
  const std::vector<Vec3>& zeros;
  const PlotTitle& title;
  ShadeScale shades;
};

/// Without its folder.
std::string name_of_file(const std::string& path);

tl::expected<void, std::string> draw_page(const ResultFile& file, const PlotScene& scene);

/// What of the path the picture shows: all the cutting, and rapid motion around it as far as half its size.
Box shown_box(const PlotScene& scene);

}  // namespace kadr
