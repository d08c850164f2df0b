#pragma once
// The signs at places of a path: where it starts and ends, where an alarm stopped it.

#include "out/picture/plot_view.h"

namespace kadr {

/// A start is a triangle, an end a square that leaves room for it, a stop a red cross.
void draw_mark(Canvas& canvas, PlotMark::What what, Vec2 at);

/// All of a view; what stands outside of `field` is shown at its edge, with an arrow that way.
void draw_marks(Canvas& canvas, View view, const ViewScale& scale, const PlotScene& scene, const Area& field);

}  // namespace kadr
