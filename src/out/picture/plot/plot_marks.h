#pragma once
// Draws the symbols on a path: its start, its end, and the position where an alarm stopped the program.

#include "out/picture/plot/plot_view.h"

namespace kadr {

/// Draws a symbol: a triangle for the start, a larger square for the end, a red cross for a stop.
void draw_mark(Canvas& canvas, PlotMark::What what, Vec2 at);

/// Draws all symbols of a view. A symbol outside the rectangle `field` is drawn at the border of the rectangle, with an arrow in the
/// direction of its true position.
void draw_marks(Canvas& canvas, View view, const ViewScale& scale, const PlotScene& scene, const Area& field);

}  // namespace kadr
