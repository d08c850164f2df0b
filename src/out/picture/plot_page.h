#pragma once
// The page of a plot: the title, a large isometric view on the left, the planes on the right, the legend below.

#include <string>
#include <vector>

#include "out/picture/plot.h"

namespace kadr {

struct PlotDifferences;

struct PlotScene {
  const PlotPath& path;
  const PlotPath& contour;  // the programmed contour, where the tool's path differs from it; may be empty
  const std::vector<Vec3>& zeros;
  const std::vector<PlotMark> marks;
  const PlotTitle& title;
  ShadeScale shades;
  std::vector<ToolDirection> tools{};            // the directions of a tilted tool
  const PlotDifferences* differences = nullptr;  // for a comparison of two programs: `path` is what both do
};

/// Returns all paths that are drawn.
std::vector<const PlotPath*> paths_of(const PlotScene& scene);

/// Returns the name without its folder.
std::string name_of_file(const std::string& path);

tl::expected<void, std::string> draw_page(const ResultFile& file, const PlotScene& scene);

/// Returns the box that a view shows: all cutting and the programmed contour. In each coordinate it includes all rapid motion too if the
/// whole path is at most `most_times` as large as the cutting; else rapid motion is shown up to a quarter of that size on either side.
Box shown_box(const PlotScene& scene, double most_times);

}  // namespace kadr
