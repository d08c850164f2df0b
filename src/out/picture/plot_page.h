#pragma once
// The page of a plot: title, the isometric view large on the left, the planes on the right, legend below.

#include <string>
#include <vector>

#include "out/picture/plot.h"

namespace kadr {

struct PlotDifferences;

struct PlotScene {
  const PlotPath& path;
  const PlotPath& contour;  // as programmed, where the tool runs beside it; may be empty
  const std::vector<Vec3>& zeros;
  const std::vector<PlotMark> marks;
  const PlotTitle& title;
  ShadeScale shades;
  std::vector<ToolDirection> tools{};            // which way the tool leans
  const PlotDifferences* differences = nullptr;  // of two programs: the path is what both do
};

/// All that are drawn.
std::vector<const PlotPath*> paths_of(const PlotScene& scene);

/// Without its folder.
std::string name_of_file(const std::string& path);

tl::expected<void, std::string> draw_page(const ResultFile& file, const PlotScene& scene);

/// What a view shows: all the cutting and the programmed contour whole; rapid motion too, where in that coordinate all is no larger than
/// `most_times` their size, else a quarter of it on either side.
Box shown_box(const PlotScene& scene, double most_times);

}  // namespace kadr
