#pragma once
// Draws the tool path in one view.

#include "out/picture/plot/plot_view.h"

namespace kadr {

/// greatest number of strokes in a scene up to which an SVG stores the program line of each stroke
inline constexpr std::size_t max_line_strokes = 10'000;
/// True if the scene has at most max_line_strokes strokes. Consecutive segments with the same type and program line count as one stroke.
bool lines_are_tagged(const PlotScene& scene);

/// Draws all strokes, the programmed contour first, so that the tool path covers it. A point on the same pixel as the previous point is
/// omitted.
void draw_strokes(Canvas& canvas, View view, const ViewScale& scale, const PlotScene& scene);

}  // namespace kadr
