#pragma once
// The path itself, in one view.

#include "out/plot_view.h"

namespace kadr {

/// Draws all strokes; points that fall on the pixel of the one before are passed over.
void draw_strokes(Canvas& canvas, View view, const ViewScale& scale, const PlotPath& path);

}  // namespace kadr
