#pragma once
// Draws the path itself in one view.

#include "out/picture/plot_view.h"

namespace kadr {

/// An SVG states the program line of each stroke if the scene has at most this many strokes.
inline constexpr std::size_t most_line_strokes = 10'000;
/// Returns true if the scene has at most that many strokes, counted by their program lines.
bool lines_are_told(const PlotScene& scene);

/// Draws all strokes, with the programmed contour below them; skips points on the same pixel as the one before.
void draw_strokes(Canvas& canvas, View view, const ViewScale& scale, const PlotScene& scene);

}  // namespace kadr
