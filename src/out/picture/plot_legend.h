#pragma once
// The legend of a plot: one row explains the strokes, the other the symbols.

#include "out/picture/plot_view.h"

namespace kadr {

/// Draws the legend from `left` to `right`.
///   y        of the second row; the first is legend_row_height above it
///   cropped  rapid motion continues beyond the picture
void draw_legend(Canvas& canvas, const PlotScene& scene, double left, double right, double y, bool cropped);

inline constexpr double legend_row_height = 24;

}  // namespace kadr
