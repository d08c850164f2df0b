#pragma once
// Draws the legend of a plot in two rows. The upper row shows line styles, the lower row shows symbols.

#include "out/picture/plot/plot_view.h"

namespace kadr {

/// Draws the legend from x = `left` to x = `right`.
///   y        y of the lower row; the upper row is legend_row_height above it
///   cropped  true: some rapid motion is outside the picture, which the legend mentions
void draw_legend(Canvas& canvas, const PlotScene& scene, double left, double right, double y, bool cropped);

inline constexpr double legend_row_height = 24;

}  // namespace kadr
