#pragma once
// The legend of a plot: two rows, what the strokes mean and what the signs mean.

#include "out/picture/plot_view.h"

namespace kadr {

/// From `left` to `right`; `y`: of the second row, the first is `row_height` above.
///   cropped  rapid motion goes on beyond the picture
void draw_legend(Canvas& canvas, const PlotScene& scene, double left, double right, double y, bool cropped);

inline constexpr double legend_row_height = 24;

}  // namespace kadr
