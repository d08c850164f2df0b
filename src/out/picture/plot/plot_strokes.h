#pragma once
// Draws the tool path in one view.

#include "out/picture/plot/plot_view.h"

namespace kadr {

/// An SVG stores the program line of each stroke if the scene has at most this number of strokes.
inline constexpr std::size_t max_line_strokes = 10'000;
/// Returns true if the scene has at most max_line_strokes strokes. Consecutive segments of the same type and program line count as one
/// stroke.
bool lines_are_tagged(const PlotScene& scene);

/// Draws all strokes; the programmed contour lies below them. Skips a point that falls on the same pixel as the point before.
void draw_strokes(Canvas& canvas, View view, const ViewScale& scale, const PlotScene& scene);

}  // namespace kadr
