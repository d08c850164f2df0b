#pragma once
// The page of a plot: the title, a large isometric view on the left, the three planes on the right, the legend at the bottom.

#include <string>
#include <vector>

#include "out/picture/plot/plot.h"

namespace kadr {

struct PlotDifferences;

struct PlotScene {
  const PlotPath& path;
  const PlotPath& contour;  // the programmed contour where the tool path differs from it; may be empty
  const std::vector<Vec3>& zeros;
  const std::vector<PlotMark> marks;
  const PlotTitle& title;
  ShadeScale shades;
  std::vector<ToolDirection> tools{};            // tool axis directions, if the tool is tilted
  const PlotDifferences* differences = nullptr;  // set for a comparison of two programs; `path` is then the path that both follow
};

/// Returns all paths that the scene draws.
std::vector<const PlotPath*> paths_of(const PlotScene& scene);

/// Returns the file name without its folder.
std::string name_of_file(const std::string& path);

tl::expected<void, std::string> draw_page(const ResultFile& file, const PlotScene& scene);

/// Returns the box that a view shows: all cutting and the programmed contour. In each coordinate it includes all rapid motion too if the
/// whole path is at most `max_times` as long as the cutting; else it extends by a quarter of the cutting's length on either side.
Box shown_box(const PlotScene& scene, double max_times);

}  // namespace kadr
