#pragma once
// The symbols on a path: where it starts and ends, and where an alarm stopped it.

#include "out/picture/plot/plot_view.h"

namespace kadr {

/// Draws the symbol: a triangle for a start, a square (larger than the triangle) for an end, a red cross for a stop.
void draw_mark(Canvas& canvas, PlotMark::What what, Vec2 at);

/// Draws all symbols of a view. A symbol outside of the rectangle `field` is drawn at the rectangle's border, with an arrow in its
/// direction.
void draw_marks(Canvas& canvas, View view, const ViewScale& scale, const PlotScene& scene, const Area& field);

}  // namespace kadr
