#pragma once
// The path itself, in one view.

#include "out/plot_view.h"

namespace kadr {

/// Draws all strokes, the programmed contour below them; points that fall on the pixel of the one before are passed over.
void draw_strokes(Canvas& canvas, View view, const ViewScale& scale, const PlotScene& scene);

}  // namespace kadr
