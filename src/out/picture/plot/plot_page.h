#pragma once
// The page of a plot. It contains the title, a large isometric view on the left, the three planes on the right, and the legend at the
// bottom. The page of a lathe has one view instead, with Z to the right and X upwards.

#include <string>
#include <vector>

#include "out/picture/plot/plot.h"

namespace kadr {

struct PlotDifferences;

struct PlotScene {
  const PlotPath& path;
  const PlotPath& contour;  // the programmed contour, as far as the tool path differs from it; may be empty
  const std::vector<Vec3>& zeros;
  const std::vector<PlotMark> marks;
  const PlotTitle& title;
  ShadeScale shades;
  std::vector<ToolDirection> tools{};  // directions of the tool axis along the path; empty if the tool is never tilted
  // differences of two programs; `path` is then the path that both programs follow; nullptr: the plot shows a single program
  const PlotDifferences* differences = nullptr;
  bool lathe = false;  // true: the page has one view, with Z to the right and X upwards
};

/// Returns all paths that the scene contains.
std::vector<const PlotPath*> paths_of(const PlotScene& scene);

/// Returns the file name without its folder.
std::string name_of_file(const std::string& path);

tl::expected<void, std::string> draw_page(const ResultFile& file, const PlotScene& scene);

/// Returns the box that a view shows. It contains all cutting and the programmed contour. In each coordinate, it also contains all rapid
/// motion if the whole path is at most `max_times` as long as the cutting; otherwise it extends by a quarter of the length of the cutting
/// on either side.
Box shown_box(const PlotScene& scene, double max_times);

}  // namespace kadr
