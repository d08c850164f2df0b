#pragma once
// The legend of a plot, in two rows: line styles above, symbols below.

#include "out/picture/plot/plot_view.h"

namespace kadr {

/// Draws the legend from x = `left` to x = `right`.
///   y        y of the second row; the first row is legend_row_height above it
///   cropped  some rapid motion lies outside the picture, which the legend mentions
void draw_legend(Canvas& canvas, const PlotScene& scene, double left, double right, double y, bool cropped);

inline constexpr double legend_row_height = 24;

}  // namespace kadr
