#pragma once
// The symbols on a path: where it starts and ends, and where an alarm stopped it.

#include "out/picture/plot_view.h"

namespace kadr {

/// Draws a start as a triangle, an end as a square with room for the triangle inside, a stop as a red cross.
void draw_mark(Canvas& canvas, PlotMark::What what, Vec2 at);

/// Draws all marks of a view; a mark outside of `field` is shown at its edge, with an arrow in its direction.
void draw_marks(Canvas& canvas, View view, const ViewScale& scale, const PlotScene& scene, const Area& field);

}  // namespace kadr
